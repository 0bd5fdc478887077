#ifndef MJFORGE_APP_INTERRUPT_H_
#define MJFORGE_APP_INTERRUPT_H_

#include <atomic>

namespace mjforge::app {

/// From now on the first SIGINT or SIGTERM only sets the flag; a second one ends
/// the program.
const std::atomic<bool>& CatchInterrupts();

/// A closed pipe and a file-size limit become failed writes instead of ends.
void IgnoreWriteSignals();

}  // namespace mjforge::app

#endif  // MJFORGE_APP_INTERRUPT_H_
