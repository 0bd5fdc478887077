// Number of cases of long tests, reduced under sanitizers.

#pragma once

/// Defined only if AddressSanitizer's runtime is linked. A macro cannot be used, because tests are
/// compiled to the same objects in every configuration.
extern "C" [[gnu::weak]] void __asan_init();

namespace mjforge::harness {

/// Returns the number of cases of a long test: `whole`, or a tenth of it (at least 1) under
/// sanitizers, which are ten times slower and look for other faults.
inline int Effort(int whole) { return __asan_init == nullptr ? whole : (whole + 9) / 10; }

/// Returns `sanitized` under sanitizers, otherwise `whole`.
inline int Effort(int whole, int sanitized) { return __asan_init == nullptr ? whole : sanitized; }

}  // namespace mjforge::harness
