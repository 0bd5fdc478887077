#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

#include "console.h"

namespace mjforge::app {

using Seconds = std::chrono::duration<double>;

/// Takes the steps 0 to count - 1 in a child process: some files make MuJoCo 2.2 crash or run for
/// ever, and files that are not ours may be made for that. A step may take so much CPU time (whole
/// seconds, rounded up), batch::WallLimit of wall time, and 8 GiB of memory. Where it takes more or
/// crashes, `crashed` is told the step and what happened ("made MuJoCo crash (SIGSEGV)"), and a new
/// child continues with the next step. Returns the worst status of all.
ExitStatus InChild(std::size_t count, Seconds time_limit,
                   const std::function<ExitStatus(std::size_t)>& take,
                   const std::function<ExitStatus(std::size_t, const std::string&)>& crashed);

/// Adds the finding of what a file or an object did.
void AddCrash(const std::string& what, const std::string& end, diag::Findings& findings);

/// One step, whose crash is a finding about `what`.
ExitStatus InChild(const std::string& what, Seconds time_limit, Console& console,
                   const std::function<ExitStatus()>& take);

}  // namespace mjforge::app
