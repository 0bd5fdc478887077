// Which way the arrows point: who may include what. The second gate beside the
// link lists of the rooms (cmake/Room.cmake), which cannot see outside libraries
// and let a room's neighbours through.

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>
#include <set>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

using WordSet = std::set<std::string_view>;

struct Room {
  std::string_view name;
  WordSet may_include;
};

const std::array kRooms = {
    Room{"bytes", {}},
    Room{"diag", {}},
    Room{"expr", {"diag"}},
    Room{"spec", {"bytes", "diag", "expr"}},
    Room{"sample", {"diag", "expr", "spec"}},
    Room{"mesh_data", {"diag", "expr"}},
    Room{"xml", {"bytes", "diag", "expr"}},
    Room{"engine", {"bytes", "diag", "mesh_data", "xml"}},
    Room{"backport", {"bytes", "diag", "xml", "engine"}},
    Room{"solid", {}},
    Room{"model", {"diag", "expr", "spec", "sample", "solid"}},
    Room{"start", {"diag", "expr", "sample", "model"}},
    Room{"assemble",
         {"bytes", "diag", "expr", "spec", "sample", "mesh_data", "solid", "model", "start"}},
    Room{"split", {"diag", "model"}},
    Room{"padding", {"sample", "model"}},
    Room{"distance", {"model"}},
    Room{"placing", {"solid", "model", "distance"}},
    Room{"static_checks", {"diag", "expr", "sample", "model", "distance"}},
    Room{"mjcf", {"bytes", "diag", "expr", "solid", "model", "start"}},
    Room{"files", {"bytes", "diag", "expr", "model", "engine", "solid", "mjcf"}},
    Room{"compiled", {"diag", "sample", "model", "engine"}},
    Room{"structure", {"bytes", "engine"}},
    Room{"attach",
         {"bytes", "diag", "expr", "spec", "sample", "xml", "model", "engine", "backport",
          "compiled"}},
    Room{"output", {"bytes", "diag", "mjcf"}},
    // expr: numbers of the base
    Room{"family",
         {"bytes", "diag", "expr", "sample", "model", "engine", "compiled", "structure", "mjcf",
          "output"}},
    // expr: numbers in messages
    Room{"validate",
         {"diag", "expr", "xml", "model", "engine", "backport", "compiled", "structure", "mjcf",
          "family"}},
    Room{"physics",
         {"bytes", "diag", "expr", "xml", "model", "static_checks", "engine", "backport",
          "compiled", "mjcf"}},
    Room{"manifest", {"bytes", "diag", "expr", "sample", "model", "mjcf", "physics"}},
    Room{"forge",
         {"bytes", "diag",    "expr",     "spec",          "sample",    "model",  "assemble",
          "split", "padding", "placing",  "static_checks", "structure", "family", "mjcf",
          "files", "attach",  "validate", "physics",       "manifest",  "output"}},
    Room{"batch",
         {"bytes", "diag", "expr", "spec", "sample", "mjcf", "family", "validate", "physics",
          "manifest", "output", "forge"}},
    Room{"picture", {"bytes", "diag", "model", "engine", "backport", "compiled"}},
    Room{"report",
         {"bytes", "diag", "expr", "spec", "sample", "physics", "manifest", "output", "forge"}},
    Room{"customize",
         {"bytes", "diag", "expr", "spec", "sample", "model", "mjcf", "physics", "manifest",
          "output", "forge", "picture"}},
    // xml: elements of files, for the Python package
    Room{
        "app",
        {"bytes", "diag", "expr", "spec", "sample", "xml", "model", "structure", "mjcf", "validate",
         "physics", "manifest", "output", "forge", "batch", "picture", "report", "customize"}},
};

struct Library {
  std::string_view prefix;  // of its includes
  WordSet rooms;
  bool in_headers = false;
};

const std::array kLibraries = {
    Library{"CLI/", {"app"}},
    Library{"EGL/", {"picture"}},  // headers alone: it is opened at run time
    Library{"Eigen/",
            {"solid",    "model",  "assemble", "start",   "distance",  "placing",  "static_checks",
             "compiled", "mjcf",   "files",    "attach",  "family",    "validate", "physics",
             "manifest", "output", "forge",    "picture", "customize", "app"},
            true},
    Library{"Random123/", {"sample"}},
    Library{"archive", {"output"}},
    Library{"boost/archive/iterators/", {"report"}},
    Library{"boost/asio/", {"app"}},
    Library{"boost/beast/", {"app"}},
    Library{"boost/container/small_vector.hpp", {"sample", "model", "assemble"}, true},
    Library{"boost/math/", {"sample", "solid", "placing"}},
    // validate: points over joint ranges; physics: points in parts
    Library{"boost/random/", {"sample", "static_checks", "validate", "physics"}},
    Library{"ccd/", {"distance"}},
    Library{"ctemplate/", {"report"}},
    Library{"fmt/", {"bytes", "diag",   "expr",     "spec",          "sample",    "mesh_data",
                     "xml",   "engine", "backport", "solid",         "model",     "assemble",
                     "start", "split",  "padding",  "static_checks", "structure", "mjcf",
                     "files", "attach", "validate", "physics",       "manifest",  "output",
                     "forge", "batch",  "picture",  "report",        "customize", "app"}},
    Library{"gcrypt.h", {"bytes"}},
    Library{"gif_lib.h", {"picture"}},
    Library{"libqhull_r/", {"solid"}},
    // The door of engine includes MuJoCo.
    Library{
        "mujoco/",
        {"engine", "compiled", "structure", "attach", "family", "validate", "physics", "picture"},
        true},
    Library{"png.h", {"bytes"}},
    // xml reads MJCF files of others, and mjcf only what it wrote.
    Library{"pugixml.hpp", {"mjcf", "xml", "engine", "physics"}},
    Library{"rapidjson/", {"spec", "manifest", "report", "customize"}},
    Library{"sanitizer/", {"picture"}},  // of the compiler
    Library{"tiny_obj_loader.h", {"assemble"}},
    Library{"webp/", {"picture"}},
    Library{"xxhash.h", {"bytes", "expr", "sample"}},
    Library{"yaml-cpp/", {"spec"}},
    Library{"zlib.h", {"output"}},  // checksums of zip files
    Library{"zstd.h", {"bytes"}},
};

const WordSet kSystem = {"dlfcn.h",        "malloc.h",      "fcntl.h",      "poll.h",
                         "sys/file.h",     "sys/ioctl.h",   "sys/mman.h",   "sys/prctl.h",
                         "sys/resource.h", "sys/syscall.h", "sys/socket.h", "sys/stat.h",
                         "sys/time.h",     "sys/types.h",   "sys/wait.h",   "unistd.h"};

const Room& RoomOf(std::string_view file) {
  const std::string_view top = "lib/mjforge/";
  const std::string_view name =
      file.starts_with(top) ? file.substr(top.size(), file.find('/', top.size()) - top.size())
                            : file.substr(0, file.find('/'));
  for (const Room& room : kRooms) {
    if (room.name == name) return room;
  }
  FAIL("no room for " << file);
  return kRooms.front();
}

bool IsDoor(std::string_view file) {
  const std::filesystem::path path(file);
  return path.parent_path().filename() == path.stem() && path.extension() == ".h";
}

std::string RoomFault(const Room& room, std::string_view include) {
  const std::filesystem::path path(include.substr(std::string_view("mjforge/").size()));
  const std::string other = path.parent_path().string();
  if (other == room.name) return "";
  if (!room.may_include.contains(other)) return "room " + other + " is not to its left";
  if (!IsDoor(include)) return "not the door of " + other;
  return "";
}

std::string LibraryFault(std::string_view file, const Room& room, std::string_view include) {
  if (include.find_first_of("/.") == std::string_view::npos) return "";  // C++'s own
  if (kSystem.contains(include)) return "";
  for (const Library& library : kLibraries) {
    if (!include.starts_with(library.prefix)) continue;
    if (!library.rooms.contains(room.name)) return "not a library of this room";
    if (!library.in_headers && IsDoor(file)) return "an outside library in a door";
    return "";
  }
  return "a library that is not in the table";
}

// What is wrong with the include, or nothing.
std::string Fault(std::string_view file, std::string_view include, bool quoted) {
  const Room& room = RoomOf(file);
  if (include.starts_with("mjforge/")) return RoomFault(room, include);
  if (!quoted) return LibraryFault(file, room, include);
  return include.find('/') == std::string_view::npos ? "" : "a path that is not from lib";
}

// Whether code outside comments says `room::`.
bool Names(std::string_view text, std::string_view room) {
  const std::string word = std::string(room) + "::";
  for (const std::string_view line : Lines(text)) {
    const std::string_view code = line.substr(0, line.find("//"));
    const std::size_t at = code.find(word);
    if (at == std::string_view::npos) continue;
    if (at == 0 || std::string_view(" (<!&{,").find(code[at - 1]) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

struct Include {
  std::string_view name;
  bool quoted = false;
};

std::optional<Include> IncludeOf(std::string_view line) {
  if (!line.starts_with("#include ")) return std::nullopt;
  const std::size_t open = line.find_first_of("<\"");
  const std::size_t close = line.find_first_of(">\"", open + 1);
  REQUIRE(close != std::string_view::npos);
  return Include{line.substr(open + 1, close - open - 1), line[open] == '"'};
}

}  // namespace

TEST_CASE("every include goes through a door, to the left, or to a library of the room") {
  const std::vector<ProjectFile> files = LibraryAndProgram();
  REQUIRE(files.size() > kRooms.size());
  for (const ProjectFile& file : files) {
    for (const std::string_view line : Lines(file.text)) {
      const std::optional<Include> include = IncludeOf(line);
      if (!include) continue;
      INFO(file.name << ": " << line);
      CHECK(Fault(file.name, include->name, include->quoted) == "");
    }
  }
}

TEST_CASE("a room names only rooms that it may include") {
  // The doors it includes show it others: what it needs of those, its neighbour names.
  const std::vector<ProjectFile> files = LibraryAndProgram();
  for (const ProjectFile& file : files) {
    const Room& own = RoomOf(file.name);
    for (const Room& other : kRooms) {
      if (other.name == own.name || own.may_include.contains(other.name)) continue;
      INFO(file.name << " names " << other.name);
      CHECK_FALSE(Names(file.text, other.name));
    }
  }
}

TEST_CASE("every room has a door") {
  for (const Room& room : kRooms) {
    if (room.name == "app") continue;
    const std::string name(room.name);
    INFO(name);
    CHECK(CppFiles("lib/mjforge/" + name + "/" + name + ".h").size() == 1);
  }
}

TEST_CASE("an include against the flow is a fault") {
  CHECK(Fault("lib/mjforge/spec/a.cc", "mjforge/sample/sample.h", true) ==
        "room sample is not to its left");
  CHECK(Fault("lib/mjforge/mjcf/a.cc", "mjforge/spec/spec.h", true) ==
        "room spec is not to its left");
  CHECK(Fault("lib/mjforge/forge/a.cc", "mjforge/app/options.h", true) ==
        "room app is not to its left");
  CHECK(Fault("app/main.cc", "mjforge/forge/forge.h", true) == "");
}

TEST_CASE("an include past another room's door is a fault") {
  CHECK(Fault("lib/mjforge/model/a.cc", "mjforge/spec/yaml.h", true) == "not the door of spec");
  CHECK(Fault("lib/mjforge/spec/a.cc", "mjforge/spec/yaml.h", true) == "");
}

TEST_CASE("an outside library in another room, in a door or not in the table is a fault") {
  CHECK(Fault("lib/mjforge/mjcf/a.cc", "mujoco/mujoco.h", false) == "not a library of this room");
  CHECK(Fault("lib/mjforge/spec/spec.h", "yaml-cpp/yaml.h", false) ==
        "an outside library in a door");
  CHECK(Fault("lib/mjforge/spec/a.cc", "curl/curl.h", false) ==
        "a library that is not in the table");
  CHECK(Fault("lib/mjforge/model/model.h", "Eigen/Dense", false) == "");
}

}  // namespace mjforge::house
