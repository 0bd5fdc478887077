// Assembler: entry point of the assembly, and caches of mesh and texture files.

#include <set>

#include "mjforge/assemble/assemble.h"
#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/mesh_files.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::assemble {

// Assembles the object. If no place is found for an optional body (`fewer: true`), assembles the
// object again without this body; all other draws keep their values. Does not assemble again after
// an error, because the evaluator would not report a failed value a second time.
std::optional<model::Object> Assembler::Assemble(sample::Evaluator& values, const Options& options,
                                                 diag::Findings& findings) {
  const std::size_t before = findings.size();
  std::set<std::string> left_out;
  for (;;) {
    const std::size_t known = left_out.size();
    std::optional<model::Object> object = Assembly(*this, left_out, findings).Run(values, options);
    if (left_out.size() == known || findings.HasErrors(before)) return object;
    findings.Truncate(before);
  }
}

const Assembler::CachedMesh& Assembler::ReadMesh(const std::filesystem::path& file) {
  const auto [found, is_new] = meshes_.try_emplace(file);
  CachedMesh& cached = found->second;
  if (!is_new) return cached;
  cached.exists = bytes::Exists(file);
  if (!cached.exists) return cached;
  std::optional<MeshFile> read = ReadMeshFile(file, cached.why_not, cached.unreadable);
  if (!read) return cached;
  cached.fit_for_mujoco = read->fit_for_mujoco;
  cached.mesh = std::move(read->mesh);
  cached.surface_defect = model::FindSurfaceDefect(*cached.mesh);
  return cached;
}

const Assembler::CachedTexture& Assembler::ReadTexture(const std::filesystem::path& file) {
  const auto [found, is_new] = textures_.try_emplace(file);
  CachedTexture& cached = found->second;
  if (!is_new) return cached;
  cached.exists = bytes::Exists(file);
  cached.pixels = bytes::PngPixels(file, cached.why_not);
  return cached;
}

const std::string& Assembler::HashOf(const std::filesystem::path& file) {
  const auto [found, is_new] = hashes_.try_emplace(file);
  if (!is_new) return found->second;
  std::string ignored;  // an unreadable file is an error of the mesh or texture that names the file
  if (const auto content = bytes::Read(file, bytes::kMaxAsset, ignored))
    found->second = bytes::HashOf(*content);
  return found->second;
}

}  // namespace mjforge::assemble
