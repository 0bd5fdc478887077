// Loads MJCF in MuJoCo without side effects: MuJoCo does not exit the process, print, or write a
// log file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/engine/api.h"
#include "mjforge/engine/geom_pairs.h"
#include "mjforge/engine/memory_files.h"
#include "mjforge/engine/mujoco_error.h"
#include "mjforge/engine/referenced_files.h"
#include "mjforge/engine/sensor_types.h"

namespace mjforge::engine {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;

/// Prefix of warnings about the convex hull of a mesh. A model with such warnings is loaded.
inline constexpr std::string_view kHullWarning = "qhull: ";

/// A memory limit of MuJoCo 2.2 that a model exceeds, as parts of a message.
struct Shortage {
  std::string_view effect;  // "ignores contacts that exceed its buffer"
  std::string_view remedy;  // "a larger `nconmax`"
};

/// The result of a load: a model or an error, and warnings in both cases.
struct Loaded {
  Model model;
  std::string error;
  std::vector<std::string> warnings;
  std::optional<FileFault> fault;  // set if a bad file or mesh kept MuJoCo from being called
  /// Memory limits of MuJoCo 2.2 that the MJCF text exceeds; empty for releases from 2.3 on.
  /// `model` may have larger buffers than the text requests.
  std::vector<Shortage> shortages;
};

/// Loads MJCF texts, whose files may be in memory, and MJCF files.
class Engine {
 public:
  /// Installs handlers in the whole process: MuJoCo's errors become exceptions
  /// (std::runtime_error, or std::bad_alloc if memory is not enough), and its warnings are
  /// collected.
  Engine();

  /// The reason why a file cannot be put into memory.
  struct AssetProblem {
    std::size_t asset = 0;  // index in the list of assets
    diag::Code code = diag::Code::kMujocoError;
    std::string message;
  };
  /// Replaces the files in memory by `assets`, under the names that the MJCF text uses. Reads each
  /// file at most once; the bytes of generated assets must live until the text is loaded. Returns
  /// the first problem; nullopt if there is none.
  std::optional<AssetProblem> SetAssets(const bytes::Assets& assets);

  /// Calls SetAssets(), and loads an MJCF text that may refer to these files. If SetAssets() fails,
  /// its message is in Loaded::error.
  Loaded LoadText(const std::string& text, const bytes::Assets& assets);
  /// Loads an MJCF text that may refer to the files of the last SetAssets().
  Loaded LoadText(const std::string& text);
  /// Loads an MJCF text as if it were a file in `folder`; reads the files that the text names from
  /// the disk.
  Loaded LoadTextIn(const std::filesystem::path& folder, const std::string& text);
  /// Loads an MJCF file or standard input, without a backport; reads the files that the MJCF names
  /// from the disk.
  Loaded LoadFile(const std::filesystem::path& file);

 private:
  /// Returns a file's content, which is read at most once. Returns null, and sets `code` and
  /// `why_not`, if the file cannot be read or is a faulty mesh (mesh_data::CheckFile).
  const std::string* ReadOnce(const std::filesystem::path& file, diag::Code& code,
                              std::string& why_not);

  MemoryFiles in_memory_;
  std::map<std::filesystem::path, std::string> files_;
};

}  // namespace mjforge::engine
