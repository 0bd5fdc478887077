// Runs work that may crash or hang (loading untrusted files in MuJoCo) in a child process, and ends
// this process with its parent.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "console.h"

namespace mjforge::app {

/// Runs `run_step` for the steps 0 to count - 1 in a child process, because some files make MuJoCo
/// 2.2 crash or hang, and untrusted files may be made for that purpose. The limits of a step are
/// `time_limit` of CPU time (rounded up to whole seconds), batch::WallLimit of wall time, and 8 GiB
/// of memory. If a step crashes or exceeds a limit, `crashed` is called with the step and the
/// reason ("made MuJoCo crash (SIGSEGV)"), and a new child continues with the next step. Returns
/// the worst status of all steps; a step that needs too much memory has the status kInputOutput.
ExitStatus RunInChild(std::size_t count, Seconds time_limit,
                      const std::function<ExitStatus(std::size_t)>& run_step,
                      const std::function<ExitStatus(std::size_t, const std::string&)>& crashed);

/// Lets this process get SIGTERM when its parent ends, if MJFORGE_PARENT is the id of the parent.
/// The Python package sets the variable, because a program that waits for a batch may be killed.
/// Linux sends the signal when the thread ends that started this process; that thread waits for it.
void EndWithParent();

/// Limits the memory of this process to 8 GiB, more than any object needs.
void LimitMemory();

/// Returns the reason of the end of a process from its wait status: "made MuJoCo crash (SIGSEGV)".
std::string DescribeEnd(int status);

/// Adds the finding that the file or spec `what` crashed or exceeded a limit, for the reason that
/// RunInChild or DescribeEnd gave.
void AddCrashFinding(const std::string& what, const std::string& reason, diag::Findings& findings);

/// Runs one step in a child process; a crash becomes a finding about the file or spec `what`.
ExitStatus RunInChild(const std::string& what, Seconds time_limit, Console& console,
                      const std::function<ExitStatus()>& run);

}  // namespace mjforge::app
