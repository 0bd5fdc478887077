// Count of processors, read once: replaces get_nprocs() of the C library for the whole program.
#include <unistd.h>

// MuJoCo asks for the count whenever it compiles a model, and the C library then reads a file of
// the system, which takes 7 % of the time of loading a hammer. The definition in a program takes
// precedence over that in a shared library.
extern "C" int get_nprocs() noexcept {
  static const int count = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
  return count;
}
