#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "console.h"

namespace mjforge::app {

/// Takes the steps 0 to count - 1 in a child process: some files make MuJoCo 2.2 crash. Where that
/// happens, `crashed` is told the step and what the end was ("SIGSEGV"), and a new child continues
/// with the next step. Returns the worst status of all.
ExitStatus InChild(std::size_t count, const std::function<ExitStatus(std::size_t)>& take,
                   const std::function<ExitStatus(std::size_t, const std::string&)>& crashed);

/// Adds the finding that MuJoCo crashed on a file or an object.
void AddCrash(const std::string& what, const std::string& end, diag::Findings& findings);

/// One step, whose crash is a finding about `what`.
ExitStatus InChild(const std::string& what, Console& console,
                   const std::function<ExitStatus()>& take);

}  // namespace mjforge::app
