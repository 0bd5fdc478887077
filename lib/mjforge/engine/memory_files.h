#pragma once

#include <map>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

/// Files that MuJoCo finds in memory: the text of a model, and what it refers to.
class MemoryFiles {
 public:
  MemoryFiles();

  /// What mj_loadXML takes. Texts and files must live as long as it is used.
  const mjVFS* Get();

  /// The model's text is found as `kTextName`.
  static constexpr const char* kTextName = "mjforge-object.xml";
  void SetText(const std::string& text);

  /// No file but the text, for a start.
  void Clear();
  enum class Added { kYes, kTooMany, kNameTaken };
  /// `name` has no folder and only small letters. The same bytes may be added twice.
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
  /// MuJoCo copies what it is given, so what many texts refer to stays.
  std::map<std::string, Entry> files_;
#else
  // Filled by hand: the memory of its files is ours, its 2 MB are touched only where used, and
  // mj_deleteFileVFS (2.2.2) never returns for any file except the last.
  using Delete = std::default_delete<mjVFS>;
  void SetFile(int slot, const std::string& name, const std::string& bytes);
#endif
  std::unique_ptr<mjVFS, Delete> vfs_;
};

}  // namespace mjforge::engine
