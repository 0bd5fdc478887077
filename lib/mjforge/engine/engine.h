#pragma once

// MuJoCo's loader without side effects: it does not exit, print, or write a log.

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
#include "mjforge/engine/adapt.h"
#include "mjforge/engine/api.h"
#include "mjforge/engine/flat_text.h"
#include "mjforge/engine/geom_pairs.h"
#include "mjforge/engine/memory_files.h"
#include "mjforge/engine/pictures.h"
#include "mjforge/engine/refusal.h"
#include "mjforge/engine/weigh_meshes.h"
#include "mjforge/engine/xml_file.h"
#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;

/// The result of a load: a model or an error, and warnings in both cases.
struct Loaded {
  Model model;
  std::string error;
  std::vector<std::string> warnings;
  int too_large_line = 0;  // not MuJoCo's error, ours: of the picture that is too much for memory
};

class Engine {
 public:
  /// Makes MuJoCo's errors C++ exceptions (std::runtime_error) and collects its warnings, in the
  /// whole process.
  Engine();

  /// Puts the files into memory under the names that the text uses, reading each once; those that
  /// are made must live until the text is loaded. If it cannot, returns the reason and the index of
  /// the asset; otherwise nothing.
  struct AssetProblem {
    std::size_t asset = 0;
    diag::Code code = diag::Code::kMujocoError;
    std::string message;
  };
  std::optional<AssetProblem> SetAssets(const bytes::Assets& assets);

  /// Loads a text that may refer to the assets.
  Loaded LoadText(const std::string& text);
  /// As if the text were a file in that folder: reads the files it refers to from the disk.
  Loaded LoadTextIn(const std::filesystem::path& folder, const std::string& text);
  /// Loads a file or standard input, and the files it refers to from the disk. If it needs a later
  /// MuJoCo, the first thing that does is the error.
  Loaded LoadFile(const std::filesystem::path& file);
  /// The same, if it was read before.
  Loaded LoadFile(const std::filesystem::path& file, const XmlFile& xml);

 private:
  /// The file's content, read at most once; null if it cannot be read.
  const std::string* ReadOnce(const std::filesystem::path& file, std::string& why_not);

  MemoryFiles in_memory_;
  std::map<std::filesystem::path, std::string> files_;
};

}  // namespace mjforge::engine
