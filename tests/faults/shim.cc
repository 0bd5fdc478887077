// A library to preload: it records what a program does to files below a folder, or makes one of its
// calls fail.
//
//   FAULTS_BELOW    only calls about this folder and what is in it count
//   FAULTS_RECORD   a file to which each call is appended: "write PATH OFFSET SIZE\n" and the
//                   bytes, "rename FROM TO\n", "sync PATH\n", "syncfs\n",
//                   "truncate PATH SIZE\n", "remove PATH\n", "mkdir PATH\n", "create PATH\n"
//   FAULTS_COUNTER  a file of eight bytes, shared by all processes: how many calls of the kind were
//                   made
//   FAULTS_FAIL     "KIND NUMBER HOW": the call of that kind and number (from 1) fails. KIND: open
//                   read write rename sync mkdir close truncate fork mmap (of memory that processes
//                   share); HOW: an errno, "short" (half of a read or write), "late" (a tenth of a
//                   second), "kill" (before the call) or "killed" (after it)

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <typename Function>
Function* Real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

std::string Variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

struct Settings {
  std::string below = Variable("FAULTS_BELOW");
  std::string kind;
  std::uint64_t number = 0;
  std::string how;
  std::atomic<std::uint64_t>* counter = nullptr;
  int record = -1;

  Settings() {
    char words[3][32] = {};
    if (std::sscanf(Variable("FAULTS_FAIL").c_str(), "%31s %31s %31s", words[0], words[1],
                    words[2]) == 3) {
      kind = words[0];
      number = std::strtoull(words[1], nullptr, 10);
      how = words[2];
    }
    auto* open = Real<int(const char*, int, ...)>("open");
    if (const std::string file = Variable("FAULTS_COUNTER"); !file.empty()) {
      const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC);
      auto* mmap = Real<void*(void*, std::size_t, int, int, int, ::off_t)>("mmap");
      void* memory = mmap(nullptr, 8, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
      if (memory != MAP_FAILED) counter = static_cast<std::atomic<std::uint64_t>*>(memory);
    }
    if (const std::string file = Variable("FAULTS_RECORD"); !file.empty())
      record = open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  }
};

const Settings& The() {
  static const Settings settings;
  return settings;
}

std::string PathOf(int descriptor) {
  char path[PATH_MAX];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t size = ::readlink(link.c_str(), path, sizeof(path));
  return size < 0 ? std::string() : std::string(path, static_cast<std::size_t>(size));
}

std::string Absolute(const char* path) {
  if (path[0] == '/') return path;
  char here[PATH_MAX];
  std::string whole = ::getcwd(here, sizeof(here)) == nullptr ? "" : here;
  std::string name = path;
  while (name.starts_with("./")) name.erase(0, 2);
  return name == "." ? whole : whole + "/" + name;
}

bool IsBelow(const std::string& path) {
  const std::string& below = The().below;
  return !below.empty() && path.starts_with(below) &&
         (path.size() == below.size() || path[below.size()] == '/');
}

enum class Fate { kGoesOn, kFails, kIsShort, kDiesAfter };

Fate FateOf(const char* kind) {
  const Settings& the = The();
  if (the.kind != kind || the.counter == nullptr) return Fate::kGoesOn;
  if (the.counter->fetch_add(1) + 1 != the.number) return Fate::kGoesOn;
  if (the.how == "kill") ::kill(0, SIGKILL);  // the whole group, as a power cut would
  if (the.how == "killed") return Fate::kDiesAfter;
  if (the.how == "short") return Fate::kIsShort;
  if (the.how == "late") {
    ::usleep(100'000);
    return Fate::kGoesOn;
  }
  errno = std::atoi(the.how.c_str());
  return Fate::kFails;
}

void Record(const std::string& line, const void* bytes = nullptr, std::size_t size = 0) {
  const int record = The().record;
  if (record < 0) return;
  std::string all = line + "\n";
  all.append(static_cast<const char*>(bytes), size);
  auto* write = Real<ssize_t(int, const void*, std::size_t)>("write");
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(record, all.data(), all.size());
  errno = error;
}

template <typename Call, typename Note>
auto Do(const char* kind, bool counts, const Call& call, const Note& note) {
  const Fate fate = counts ? FateOf(kind) : Fate::kGoesOn;
  if (fate == Fate::kFails) return static_cast<decltype(call())>(-1);
  const auto result = call();
  if (counts && result >= 0) note(result);
  if (fate == Fate::kDiesAfter) ::kill(0, SIGKILL);
  return result;
}

int Open(const char* name, const char* path, int flags, ::mode_t mode) {
  auto* open = Real<int(const char*, int, ...)>(name);
  const std::string absolute = Absolute(path);
  struct stat status;
  const bool is_new = (flags & O_CREAT) != 0 && ::lstat(path, &status) != 0;
  return Do(
      "open", IsBelow(absolute), [&] { return open(path, flags, mode); },
      [&](int) {
        if (is_new) Record("create " + absolute);
      });
}

::mode_t ModeOf(int flags, std::va_list list) {
  return (flags & O_CREAT) != 0 ? va_arg(list, ::mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list list;
  va_start(list, flags);
  const ::mode_t mode = ModeOf(flags, list);
  va_end(list);
  return Open("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  std::va_list list;
  va_start(list, flags);
  const ::mode_t mode = ModeOf(flags, list);
  va_end(list);
  return Open("open64", path, flags, mode);
}

ssize_t read(int descriptor, void* bytes, std::size_t size) {
  auto* real = Real<ssize_t(int, void*, std::size_t)>("read");
  if (The().kind != "read" || !IsBelow(PathOf(descriptor))) return real(descriptor, bytes, size);
  const Fate fate = FateOf("read");
  if (fate == Fate::kFails) return -1;
  const ssize_t count = real(descriptor, bytes, fate == Fate::kIsShort ? (size + 1) / 2 : size);
  if (fate == Fate::kDiesAfter) ::kill(0, SIGKILL);
  return count;
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  auto* real = Real<ssize_t(int, const void*, std::size_t)>("write");
  const std::string path = PathOf(descriptor);
  if (!IsBelow(path)) return real(descriptor, bytes, size);
  const Fate fate = FateOf("write");
  if (fate == Fate::kFails) return -1;
  const std::size_t wanted = fate == Fate::kIsShort ? (size + 1) / 2 : size;
  const bool appends = (::fcntl(descriptor, F_GETFL) & O_APPEND) != 0;
  const ::off_t offset = ::lseek(descriptor, 0, appends ? SEEK_END : SEEK_CUR);
  const ssize_t written = real(descriptor, bytes, wanted);
  if (written > 0) {
    Record("write " + path + " " + std::to_string(offset) + " " + std::to_string(written), bytes,
           static_cast<std::size_t>(written));
  }
  if (fate == Fate::kDiesAfter) ::kill(0, SIGKILL);
  return written;
}

int rename(const char* from, const char* to) {
  auto* real = Real<int(const char*, const char*)>("rename");
  return Do(
      "rename", IsBelow(Absolute(to)), [&] { return real(from, to); },
      [&](int) { Record("rename " + Absolute(from) + " " + Absolute(to)); });
}

int unlink(const char* path) {
  auto* real = Real<int(const char*)>("unlink");
  return Do(
      "unlink", IsBelow(Absolute(path)), [&] { return real(path); },
      [&](int) { Record("remove " + Absolute(path)); });
}

int mkdir(const char* path, ::mode_t mode) {
  auto* real = Real<int(const char*, ::mode_t)>("mkdir");
  return Do(
      "mkdir", IsBelow(Absolute(path)), [&] { return real(path, mode); },
      [&](int) { Record("mkdir " + Absolute(path)); });
}

int fsync(int descriptor) {
  auto* real = Real<int(int)>("fsync");
  const std::string path = PathOf(descriptor);
  return Do(
      "sync", IsBelow(path), [&] { return real(descriptor); },
      [&](int) { Record("sync " + path); });
}

int fdatasync(int descriptor) {
  auto* real = Real<int(int)>("fdatasync");
  const std::string path = PathOf(descriptor);
  return Do(
      "sync", IsBelow(path), [&] { return real(descriptor); },
      [&](int) { Record("sync " + path); });
}

int syncfs(int descriptor) {
  auto* real = Real<int(int)>("syncfs");
  return Do(
      "sync", IsBelow(PathOf(descriptor)), [&] { return real(descriptor); },
      [&](int) { Record("syncfs"); });
}

int ftruncate(int descriptor, ::off_t size) {
  auto* real = Real<int(int, ::off_t)>("ftruncate");
  const std::string path = PathOf(descriptor);
  return Do(
      "truncate", IsBelow(path), [&] { return real(descriptor, size); },
      [&](int) { Record("truncate " + path + " " + std::to_string(size)); });
}

int ftruncate64(int descriptor, ::off_t size) { return ftruncate(descriptor, size); }

// The descriptor is closed, whatever is said.
int close(int descriptor) {
  auto* real = Real<int(int)>("close");
  const bool counts = !The().kind.empty() && IsBelow(PathOf(descriptor));
  const Fate fate = counts ? FateOf("close") : Fate::kGoesOn;
  const int error = errno;
  const int result = real(descriptor);
  if (fate == Fate::kDiesAfter) ::kill(0, SIGKILL);
  if (fate != Fate::kFails) return result;
  errno = error;
  return -1;
}

void* mmap(void* place, std::size_t size, int protection, int flags, int descriptor,
           ::off_t offset) {
  auto* real = Real<void*(void*, std::size_t, int, int, int, ::off_t)>("mmap");
  constexpr int kShared = MAP_SHARED | MAP_ANONYMOUS;
  const bool counts = (flags & kShared) == kShared;
  const Fate fate = counts ? FateOf("mmap") : Fate::kGoesOn;
  if (fate == Fate::kFails) return MAP_FAILED;
  void* memory = real(place, size, protection, flags, descriptor, offset);
  if (fate == Fate::kDiesAfter) ::kill(0, SIGKILL);
  return memory;
}

::pid_t fork() {
  auto* real = Real<::pid_t()>("fork");
  return Do(
      "fork", true, [&] { return real(); }, [](::pid_t) {});
}

}  // extern "C"
