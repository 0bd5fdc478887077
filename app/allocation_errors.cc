// Handler of failed allocations, installed before any library allocates memory.
#include <unistd.h>

#include <cerrno>

#include "usage.h"

// Function of the allocator mimalloc; null under sanitizers, where mimalloc is not linked.
extern "C" [[gnu::weak]] void mi_register_error(void (*handler)(int, void*), void* argument);

namespace mjforge::app {
namespace {

::pid_t program_process = 0;

// Ends the process if an allocation failed, because many C libraries use memory without checking
// the allocation. Prints the reason unless the process is a child, whose failure its parent
// reports.
void OnAllocationError(int error, void*) {
  if (error != ENOMEM) return;
  if (::getpid() == program_process) ExplainNoMemory();
  ::_exit(static_cast<int>(ExitStatus::kInputOutput));
}

// Runs before the initialization of the libraries, because their static objects allocate memory.
void WatchAllocations() {
  program_process = ::getpid();
  if (&mi_register_error != nullptr) mi_register_error(OnAllocationError, nullptr);
}
[[gnu::section(".preinit_array"), gnu::used]] void (*before_libraries)() = WatchAllocations;

}  // namespace
}  // namespace mjforge::app
