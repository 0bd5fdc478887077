// Loads MJCF in MuJoCo, with handlers for errors and warnings, and with files in memory.
#include "mjforge/engine/engine.h"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/captured_stderr.h"
#include "mjforge/mesh_data/mesh_data.h"
#include "mjforge/xml/xml.h"

namespace mjforge::engine {
namespace {

using diag::Code;

// Warnings of the load that the thread runs. Local to the thread, because MuJoCo calls handlers on
// the loading thread, without user data.
thread_local std::vector<std::string> thread_warnings;

// Returns true for the messages of mju_malloc and of LodePNG about a lack of memory.
bool IsOutOfMemory(std::string_view message) {
  return message.find("ould not allocate memory") != std::string_view::npos ||
         message.find("memory allocation failed") != std::string_view::npos;
}

// Handler of MuJoCo's errors, which must not return. MuJoCo itself catches errors within a
// compilation (longjmp in mjCModel::Compile). Elsewhere the exception leaves mj_loadXML, and the
// std::lock_guard in mj_loadXML releases MuJoCo's mutex.
[[noreturn]] void ThrowError(const char* message) {
  if (IsOutOfMemory(message)) throw std::bad_alloc();
  throw std::runtime_error(message);
}
void StoreWarning(const char* message) { thread_warnings.emplace_back(message); }

// Inserts Qhull's last message after the words "qhull error" of MuJoCo's error. If the model was
// loaded in spite of Qhull's messages, adds all messages to the warnings instead.
void AddQhullMessages(const std::vector<std::string>& messages, Loaded& loaded) {
  constexpr std::string_view kError = "qhull error";
  const std::size_t at = loaded.error.find(kError);
  if (at != loaded.error.npos && !messages.empty()) {
    loaded.error.insert(at + kError.size(), ": " + messages.back());
  } else if (loaded.model) {
    for (const std::string& message : messages)
      loaded.warnings.push_back(std::string(kHullWarning) + message);
  }
}

/// Enlarges the stack of a model in MuJoCo 2.2 to the size that MuJoCo reserves for models without
/// `nstack`, plus room for a list of all pairs of bodies. Changes nothing in later releases.
void ReserveStack(mjModel& m) {
  if (!kHasFixedBuffers) return;
  BufferSizes sizes = BufferSizesOf(m);
  const double size = sizes.rows + static_cast<double>(m.neq + m.nv);
  const auto bodies = static_cast<double>(m.nbody);
  sizes.numbers = std::max(sizes.numbers, 5 * size * size + bodies * bodies);
  SetBufferSizes(m, sizes);
}

Loaded Load(const char* file, const mjVFS* vfs) {
  std::array<char, 1000> message = {};
  thread_warnings.clear();
  Loaded loaded;
  const CapturedStderr captured;
  const std::optional<std::string> failure = FailureOf([&] {
    loaded.model.reset(mj_loadXML(file, vfs, message.data(), static_cast<int>(message.size())));
    if (!loaded.model) {
      loaded.error = message[0] != 0 ? message.data() : "no reason given";
    } else if (message[0] != 0) {
      thread_warnings.emplace_back(message.data());
    }
    if (loaded.model) ReserveStack(*loaded.model);
  });
  if (failure) loaded.error = *failure;
  if (IsOutOfMemory(loaded.error)) throw std::bad_alloc();
  loaded.warnings.swap(thread_warnings);
  AddQhullMessages(captured.QhullMessages(), loaded);
  return loaded;
}

// Phrases in MuJoCo's warnings and errors, each with the shortage that the phrase reports.
constexpr std::pair<std::string_view, Shortage> kShortages[] = {
    {"contact buffer is full", {"ignores contacts that exceed its buffer", "a larger `nconmax`"}},
    {"constraint buffer is full",
     {"ignores constraints that exceed its buffer", "a larger `njmax`"}},
    {"Stack overflow", {"rejects the model, because its stack is too small", "a larger `nstack`"}},
    {"could not create mjData",
     {"rejects the model, because it cannot address so many constraint rows",
      "a smaller `njmax`"}}};
// Stack sizes that LoadWithStack() tries, in numbers (8 bytes): enough for the lists of all pairs
// of 4,000 and of 15,000 bodies. The operating system provides only the pages that MuJoCo touches.
constexpr std::string_view kStackSizes[] = {"10000000", "120000000"};

/// Adds the shortage that MuJoCo's message reports to `shortages`; returns false if the message
/// reports none.
bool AddShortage(const std::string& message, std::vector<Shortage>& shortages) {
  const auto found = std::ranges::find_if(kShortages, [&](const auto& known) {
    return kHasFixedBuffers && message.find(known.first) != std::string::npos;
  });
  if (found == std::end(kShortages)) return false;
  shortages.push_back(found->second);
  return true;
}

/// Loads a text as `file`, which may refer to the files in memory. If MuJoCo 2.2 reports a
/// shortage, loads copies of the text with larger stacks and small other buffers, because a load
/// needs only the stack.
Loaded LoadWithStack(const std::filesystem::path& file, const std::string& text,
                     MemoryFiles& in_memory) {
  const auto load_once = [&](const std::string& attempt) {
    in_memory.SetText(attempt);
    Loaded loaded = Load(file.c_str(), in_memory.Get());
    std::erase_if(loaded.warnings,
                  [&](const auto& warning) { return AddShortage(warning, loaded.shortages); });
    return loaded;
  };
  Loaded loaded = load_once(text);
  const std::size_t end = text.rfind("</mujoco");
  if (loaded.model || end == text.npos || !AddShortage(loaded.error, loaded.shortages))
    return loaded;
  for (const std::string_view size : kStackSizes) {
    Loaded larger = load_once(std::string(text).insert(
        end, fmt::format(R"(<size njmax="500" nconmax="100" nstack="{}"/>)", size)));
    larger.shortages = loaded.shortages;
    if (larger.model) return larger;
  }
  return loaded;
}

Loaded Refused(const FileFault& fault) {
  Loaded loaded;
  loaded.error = fault.message;
  loaded.fault = fault;
  return loaded;
}

/// Returns MuJoCo's name for a file in memory: without folders, in lower case.
std::string NameInMemory(std::string_view name) {
  return diag::LowerCase(name.substr(name.find_last_of("/\\") + 1));
}

}  // namespace

Engine::Engine() {
  mju_user_error = ThrowError;
  mju_user_warning = StoreWarning;
}

const std::string* Engine::ReadOnce(const std::filesystem::path& file, Code& code,
                                    std::string& why_not) {
  const auto found = files_.find(file);
  if (found != files_.end()) return &found->second;
  std::optional<std::string> content = bytes::Read(file, bytes::kMaxAsset, why_not);
  code = xml::UnreadableCode(file);
  if (!content) return nullptr;
  if (const auto format = mesh_data::FormatOf(file.string())) {
    code = Code::kModelBadMesh;
    why_not = mesh_data::CheckFile(*format, *content).fault;
    if (!why_not.empty()) return nullptr;
  }
  return &files_.emplace(file, *std::move(content)).first->second;
}

std::optional<Engine::AssetProblem> Engine::SetAssets(const bytes::Assets& assets) {
  in_memory_.Clear();
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const auto& [name, file, made] = assets[i];
    std::string why_not;
    Code code = Code::kMujocoError;
    const std::string* bytes = made ? made.get() : ReadOnce(file, code, why_not);
    if (bytes == nullptr) {
      return AssetProblem{i, code, fmt::format("cannot read '{}': {}", file.string(), why_not)};
    }
    if (bytes->empty()) {
      return AssetProblem{i, Code::kModelFileNotFound, fmt::format("'{}' is empty", file.string())};
    }
    switch (in_memory_.Add(NameInMemory(name), *bytes)) {
      case MemoryFiles::Added::kYes:
        break;
      case MemoryFiles::Added::kTooMany:
        return AssetProblem{
            i, Code::kMujocoError,
            fmt::format(
                "'{}' exceeds MuJoCo's limit of 1998 files with names of at most 999 characters",
                name)};
      case MemoryFiles::Added::kNameTaken:
        return AssetProblem{i, Code::kMujocoError,
                            fmt::format("'{}' differs from another file's name only in case or "
                                        "folder, which MuJoCo cannot tell apart",
                                        name)};
    }
  }
  return std::nullopt;
}

Loaded Engine::LoadText(const std::string& text, const bytes::Assets& assets) {
  if (const std::optional<AssetProblem> problem = SetAssets(assets)) {
    Loaded loaded;
    loaded.error = problem->message;
    return loaded;
  }
  return LoadText(text);
}

Loaded Engine::LoadText(const std::string& text) {
  return LoadWithStack(MemoryFiles::kTextName, text, in_memory_);
}

Loaded Engine::LoadTextIn(const std::filesystem::path& folder, const std::string& text) {
  if (const auto fault = FindFileFault(text, folder)) return Refused(*fault);
  in_memory_.Clear();
  return LoadWithStack(folder / MemoryFiles::kTextName, text, in_memory_);
}

Loaded Engine::LoadFile(const std::filesystem::path& file) {
  Loaded failed;
  const auto text = bytes::Read(file, bytes::kMaxMjcf, failed.error);
  if (!text) return failed;
  return LoadTextIn(file == bytes::kStandardInput ? "." : file.parent_path(), *text);
}

}  // namespace mjforge::engine
