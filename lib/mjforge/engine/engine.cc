// Loads MJCF in MuJoCo: handlers for errors and warnings, files in memory.
#include "mjforge/engine/engine.h"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/captured_stderr.h"
#include "mjforge/xml/xml.h"

namespace mjforge::engine {
namespace {

using diag::Code;

// Warnings of the current load. MuJoCo calls handlers on the loading thread, without user data.
thread_local std::vector<std::string> thread_warnings;

// Returns true for the errors of mju_malloc and of LodePNG if memory is not enough.
bool IsOutOfMemory(std::string_view message) {
  return message.find("ould not allocate memory") != std::string_view::npos ||
         message.find("memory allocation failed") != std::string_view::npos;
}

// The handler of mju_error must not return. Within a compilation MuJoCo catches its own errors
// (longjmp in mjCModel::Compile); elsewhere the exception leaves mj_loadXML, whose std::lock_guard
// releases the mutex.
[[noreturn]] void ThrowError(const char* message) {
  if (IsOutOfMemory(message)) throw std::bad_alloc();
  throw std::runtime_error(message);
}
void StoreWarning(const char* message) { thread_warnings.emplace_back(message); }

// Adds Qhull's reasons to MuJoCo's "qhull error", or to the warnings if the model was loaded.
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

Loaded Load(const char* file, const mjVFS* vfs) {
  std::array<char, 1000> message = {};
  thread_warnings.clear();
  Loaded loaded;
  const CapturedStderr captured;
  try {
    loaded.model.reset(mj_loadXML(file, vfs, message.data(), static_cast<int>(message.size())));
    if (!loaded.model) {
      loaded.error = message[0] != 0 ? message.data() : "no reason given";
    } else if (message[0] != 0) {
      thread_warnings.emplace_back(message.data());
    }
  } catch (const std::bad_alloc&) {
    throw;  // not an error of the model
  } catch (const std::exception& error) {
    loaded.error = error.what();
  }
  if (IsOutOfMemory(loaded.error)) throw std::bad_alloc();
  loaded.warnings.swap(thread_warnings);
  AddQhullMessages(captured.QhullMessages(), loaded);
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

const std::string* Engine::ReadOnce(const std::filesystem::path& file, std::string& why_not) {
  const auto found = files_.find(file);
  if (found != files_.end()) return &found->second;
  std::optional<std::string> content = bytes::Read(file, bytes::kMaxAsset, why_not);
  return content ? &files_.emplace(file, *std::move(content)).first->second : nullptr;
}

std::optional<Engine::AssetProblem> Engine::SetAssets(const bytes::Assets& assets) {
  in_memory_.Clear();
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const auto& [name, file, made] = assets[i];
    std::string why_not;
    const std::string* bytes = made ? made.get() : ReadOnce(file, why_not);
    if (bytes == nullptr) {
      return AssetProblem{i, xml::UnreadableCode(file),
                          fmt::format("cannot read '{}': {}", file.string(), why_not)};
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

Loaded Engine::LoadText(const std::string& text) {
  in_memory_.SetText(text);
  return Load(MemoryFiles::kTextName, in_memory_.Get());
}

Loaded Engine::LoadTextIn(const std::filesystem::path& folder, const std::string& text) {
  if (const auto fault = FindFileFault(text, folder)) return Refused(*fault);
  in_memory_.Clear();
  in_memory_.SetText(text);
  return Load((folder / MemoryFiles::kTextName).c_str(), in_memory_.Get());
}

Loaded Engine::LoadFile(const std::filesystem::path& file) {
  Loaded failed;
  if (file == bytes::kStandardInput) {
    const auto text = bytes::Read(file, bytes::kMaxMjcf, failed.error);
    if (text) return LoadTextIn(".", *text);
  } else if (const auto text = bytes::Read(file, bytes::kMaxMjcf, failed.error)) {
    if (const auto fault = FindFileFault(*text, file.parent_path())) return Refused(*fault);
    return Load(file.c_str(), nullptr);
  }
  return failed;
}

}  // namespace mjforge::engine
