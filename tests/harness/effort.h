#pragma once

/// Defined only where AddressSanitizer's runtime is linked. Tests are compiled to the same objects
/// in every configuration, so no macro tells them.
extern "C" [[gnu::weak]] void __asan_init();

namespace mjforge::harness {

/// How many of `whole` cases a long test takes: under sanitizers, which make it ten times as slow
/// and look for other faults, a tenth, at least 1.
inline int Effort(int whole) { return __asan_init == nullptr ? whole : (whole + 9) / 10; }

/// The same, for a test that says how many these are.
inline int Effort(int whole, int sanitized) { return __asan_init == nullptr ? whole : sanitized; }

}  // namespace mjforge::harness
