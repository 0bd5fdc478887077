// Capture of the text that a test prints to standard error.

#pragma once

#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>

namespace mjforge::harness {

/// Returns the text that `run` writes to the descriptor of standard error.
inline std::string StandardErrorOf(const std::function<void()>& run) {
  std::FILE* const file = std::tmpfile();
  const int own = ::dup(STDERR_FILENO);
  ::dup2(::fileno(file), STDERR_FILENO);
  run();
  ::dup2(own, STDERR_FILENO);
  ::close(own);
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

}  // namespace mjforge::harness
