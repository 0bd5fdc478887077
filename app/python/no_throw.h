// Calls that turn exceptions into return values, for functions that C code calls.
#pragma once

#include <exception>
#include <utility>

namespace mjforge::python {

/// Returns the result of a call, or `otherwise` if the call throws, because C cannot receive
/// exceptions.
template <typename Result, typename Call>
Result NoThrow(Result otherwise, const Call& call) {
  try {
    return call();
  } catch (const std::exception&) {
    return otherwise;
  }
}

/// Makes an object; returns null if there is not enough memory.
template <typename T, typename... Arguments>
T* NewOrNull(Arguments&&... arguments) {
  return NoThrow<T*>(nullptr, [&] { return new T(std::forward<Arguments>(arguments)...); });
}

}  // namespace mjforge::python
