// Access to MuJoCo's virtual file system (mjVFS), by the functions of MuJoCo 3.2 and later, or by
// the members of the structure in older releases.
#include "mjforge/engine/memory_files.h"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace mjforge::engine {

#if mjVERSION_HEADER >= 320

MemoryFiles::MemoryFiles() : vfs_(new mjVFS) { mj_defaultVFS(vfs_.get()); }

void MemoryFiles::Delete::operator()(mjVFS* vfs) const {
  mj_deleteVFS(vfs);
  delete vfs;
}

const mjVFS* MemoryFiles::Get() {
  for (auto entry = files_.begin(); entry != files_.end();) {
    if (entry->second.wanted) {
      ++entry;
    } else {
      mj_deleteFileVFS(vfs_.get(), entry->first.c_str());
      entry = files_.erase(entry);
    }
  }
  return vfs_.get();
}

void MemoryFiles::SetText(const std::string& text) {
  // Adds every text anew. Add() would skip a text that is at the address of the previous text.
  mj_deleteFileVFS(vfs_.get(), kTextName);
  mj_addBufferVFS(vfs_.get(), kTextName, text.data(), static_cast<int>(text.size()));
}

void MemoryFiles::Clear() {
  for (auto& [name, entry] : files_) entry.wanted = false;
}

MemoryFiles::Added MemoryFiles::Add(const std::string& name, const std::string& bytes) {
  Entry& entry = files_[name];
  if (entry.bytes != &bytes) {
    if (entry.wanted) return Added::kNameTaken;
    if (entry.bytes != nullptr) mj_deleteFileVFS(vfs_.get(), name.c_str());
    if (mj_addBufferVFS(vfs_.get(), name.c_str(), bytes.data(), static_cast<int>(bytes.size())) !=
        0)
      throw std::bad_alloc();
  }
  entry = {.bytes = &bytes, .wanted = true};
  return Added::kYes;
}

#else

MemoryFiles::MemoryFiles() : vfs_(std::make_unique_for_overwrite<mjVFS>()) { Clear(); }

const mjVFS* MemoryFiles::Get() { return vfs_.get(); }

void MemoryFiles::SetFile(int slot, const std::string& name, const std::string& bytes) {
  char* stored = vfs_->filename[slot];
  stored[name.copy(stored, mjMAXVFSNAME - 1)] = 0;
  vfs_->filesize[slot] = static_cast<int>(bytes.size());
  // mjVFS requires a pointer to non-constant bytes, but MuJoCo does not change them.
  vfs_->filedata[slot] = const_cast<char*>(bytes.data());
}

void MemoryFiles::SetText(const std::string& text) { SetFile(0, kTextName, text); }

void MemoryFiles::Clear() { vfs_->nfile = 1; }

MemoryFiles::Added MemoryFiles::Add(const std::string& name, const std::string& bytes) {
  if (vfs_->nfile >= mjMAXVFS || name.size() >= mjMAXVFSNAME) return Added::kTooMany;
  int same = 1;
  while (same < vfs_->nfile && name != vfs_->filename[same]) ++same;
  if (same == vfs_->nfile) SetFile(vfs_->nfile++, name, bytes);
  return vfs_->filedata[same] == bytes.data() ? Added::kYes : Added::kNameTaken;
}

#endif

}  // namespace mjforge::engine
