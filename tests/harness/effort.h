#pragma once

namespace mjforge::harness {

/// How many of `whole` cases a long test takes: under sanitizers, which make it ten times as slow
/// and look for other faults, a fifth.
constexpr int Effort(int whole) {
#ifdef __SANITIZE_ADDRESS__
  return (whole + 4) / 5;
#else
  return whole;
#endif
}

}  // namespace mjforge::harness
