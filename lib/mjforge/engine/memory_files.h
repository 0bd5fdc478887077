// Files in memory for mj_loadXML, in MuJoCo's virtual file system (mjVFS).
#pragma once

#include <map>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

/// Files that MuJoCo reads from memory: the text of a model, and its assets.
class MemoryFiles {
 public:
  MemoryFiles();

  /// Returns the file system for mj_loadXML. Texts and bytes that were passed to SetText() and
  /// Add() must live as long as the file system is used.
  const mjVFS* Get();

  /// File name of the model's text.
  static constexpr const char* kTextName = "mjforge-object.xml";
  /// Replaces the text of the model, which MuJoCo reads as the file kTextName.
  void SetText(const std::string& text);

  /// Removes all files except the text of the model.
  void Clear();
  enum class Added { kYes, kTooMany, kNameTaken };
  /// Adds a file. `name` must have no folder and no capital letters. Returns kNameTaken if other
  /// bytes have this name (the same `bytes` object may be added again), and kTooMany if MuJoCo
  /// before 3.2 has no room for the file or its name.
  Added Add(const std::string& name, const std::string& bytes);

 private:
#if mjVERSION_HEADER >= 320
  struct Entry {
    const std::string* bytes = nullptr;
    bool wanted = false;
  };
  struct Delete {
    void operator()(mjVFS* vfs) const;
  };
  /// Files that MuJoCo has copied into its file system, by name. Clear() only marks files as not
  /// wanted, and Get() removes only the files that were not added again, because copying takes
  /// time.
  std::map<std::string, Entry> files_;
#else
  // MuJoCo's functions are not used here, because they copy files and touch all of the 2 MB
  // structure, and mj_deleteFileVFS (2.2.2) does not return unless the file is the last one.
  using Delete = std::default_delete<mjVFS>;
  void SetFile(int slot, const std::string& name, const std::string& bytes);
#endif
  std::unique_ptr<mjVFS, Delete> vfs_;
};

}  // namespace mjforge::engine
