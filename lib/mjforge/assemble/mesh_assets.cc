// Meshes of an object: inline meshes and mesh files, sharing of equal meshes, and names of output
// files.

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/mesh_files.h"
#include "mjforge/assemble/names.h"
#include "mjforge/diag/diag.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Returns a hash of the vertices. The triangles are left out, because meshes with equal vertices
// rarely differ otherwise.
std::size_t HashOf(const model::TriangleMesh& mesh) {
  const std::string_view bytes(reinterpret_cast<const char*>(mesh.vertices.data()),
                               mesh.vertices.size() * sizeof(Eigen::Vector3d));
  return std::hash<std::string_view>()(bytes);
}

std::size_t HashOf(const std::filesystem::path& file, const Eigen::Vector3d& scale) {
  const std::string_view bytes(reinterpret_cast<const char*>(scale.data()), sizeof(scale));
  return std::hash<std::string_view>()(file.native()) ^ std::hash<std::string_view>()(bytes);
}

// Returns a file's normalized absolute path, so that a mesh is shared even if specs write its path
// differently; an empty path for an inline mesh.
std::filesystem::path AbsolutePath(const std::filesystem::path& file) {
  return file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
}

bool AreSame(const model::TriangleMesh& a, const model::TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.normals == b.normals &&
         a.texcoords == b.texcoords;
}

// Returns true for characters that some operating system rejects in file names.
bool IsUnportable(char c) {
  constexpr unsigned char kDelete = 0x7f;
  const auto byte = static_cast<unsigned char>(c);
  return byte < ' ' || byte == kDelete ||
         std::string_view("\\:*?\"<>|").find(c) != std::string_view::npos;
}

// Replaces characters that are invalid on systems where archives may be unpacked. The backslash is
// replaced, too, because MuJoCo treats it like a slash.
std::string PortableName(std::string name) {
  std::ranges::replace_if(name, IsUnportable, '_');
  return name;
}

// Cuts a name to 60 bytes, because names in archives have at most 100, and not within a character.
std::string ShortStem(std::string stem) {
  const auto is_within = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  std::size_t end = std::min<std::size_t>(stem.size(), 60);
  while (end > 0 && end < stem.size() && is_within(stem[end])) --end;
  stem.resize(end);
  return stem;
}

}  // namespace

std::optional<sample::Numbers> ReadScale(FieldReader& reader, const spec::Entry& entry,
                                         std::size_t count) {
  const spec::Field* field = entry.Find(Key::kScale);
  if (field == nullptr) return sample::Numbers(count, 1);
  sample::Numbers numbers;
  if (!reader.Numbers(*field, numbers)) return std::nullopt;
  for (double number : numbers) {
    if (number != 0) continue;
    reader.Report(Code::kModelBadValue, *field, "is zero");
    return std::nullopt;
  }
  if (numbers.size() == 1) numbers.resize(count, numbers[0]);
  if (!reader.HasCount(*field, numbers, count)) return std::nullopt;
  return numbers;
}

const spec::Field* Required(FieldReader& reader, const spec::Entry& entry, Key id,
                            std::string_view key, diag::SourceMark mark) {
  const spec::Field* field = entry.Find(id);
  if (field == nullptr) {
    reader.ReportElement(Code::kSpecMissingKey, mark, fmt::format("has no '{}'", key));
  }
  return field;
}

void Assets::SetMesh(int index, model::Part& part) {
  part.mesh = index;
  part.shape = {.type = model::GeomType::kMesh,
                .mesh = &object_.meshes[static_cast<std::size_t>(index)]->mesh};
}

void Assets::AddInline(const model::TriangleMesh& mesh, model::Part& part) {
  const std::size_t hash = HashOf(mesh);
  const auto known = FindIndex(meshes_, hash, [&](std::size_t i) {
    return sources_[i].file.empty() && AreSame(object_.meshes[i]->mesh, mesh);
  });
  if (known) return SetMesh(*known, part);
  auto asset = std::make_unique<model::MeshAsset>();
  asset->name = part.name;
  asset->mesh = mesh;
  asset->is_hull = mesh.normals.empty();
  asset->mark = part.mark;
  SetMesh(Add(std::move(asset), {}, hash), part);
}

bool Assets::ReadMesh(FieldReader& reader, const spec::Entry& entry,
                      const std::filesystem::path& folder, model::Part& part) {
  const spec::Field* field = Required(reader, entry, Key::kFile, "file", part.mark);
  if (field == nullptr) return false;
  const std::optional<std::string> name = reader.Text(*field);
  const std::optional<sample::Numbers> factors = ReadScale(reader, entry, 3);
  if (!name || !factors) return false;
  const Eigen::Vector3d scale(factors->data());
  const std::filesystem::path file = (folder / *name).lexically_normal();
  const Assembler::CachedMesh& content = assembler_.ReadMesh(file);
  const auto fail = [&](Code code, std::string message, std::string hint = {}) {
    diag::Finding& finding =
        findings_.Add(code, field->value.mark, std::move(message), std::move(hint));
    finding.files = {file.string()};
    return false;
  };
  if (!content.exists)
    return fail(Code::kModelFileNotFound,
                fmt::format("{}: no file {}", reader.Owner(), Quoted(*name)),
                "file names are relative to the folder of the spec");
  if (!content.mesh)
    return fail(content.unreadable ? Code::kYamlCannotRead : Code::kModelBadMesh,
                fmt::format("cannot read mesh {}: {}", Quoted(*name), content.why_not));
  std::string inertia;
  if (!reader.ReadOptional(entry, Key::kInertia, &FieldReader::Word, inertia)) return false;
  part.is_shell = inertia == "shell";
  if (content.surface_defect && !part.is_shell && part.role != model::Role::kVisual) {
    findings_.Add(
        Code::kModelBadMesh, field->value.mark,
        fmt::format("mesh {} is not a closed surface: {}", Quoted(*name), *content.surface_defect),
        "repair the file, or give the part `role: visual`, or `inertia: shell` and a mass");
    return false;
  }
  AddFile(file, scale, content, part);
  if (part.is_shell) part.solid = model::ShellMassOf(*part.shape.mesh);
  return true;
}

void Assets::AddFile(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                     const Assembler::CachedMesh& content, model::Part& part) {
  const std::filesystem::path path = AbsolutePath(file);
  const std::size_t hash = HashOf(path, scale);
  const auto known = FindIndex(meshes_, hash, [&](std::size_t i) {
    const model::MeshAsset& other = *object_.meshes[i];
    // From a file that is not fit for MuJoCo, MuJoCo may read another mesh than mjforge, such as
    // the first of several shapes. Meshes of attached MJCF files are always read by MuJoCo.
    const bool is_same_mesh = other.file.empty() != content.fit_for_mujoco;
    return sources_[i].file == path && sources_[i].scale == scale && other.attributes.empty() &&
           is_same_mesh;
  });
  if (known) {
    // Unknown so far for a mesh of an attached file.
    sources_[static_cast<std::size_t>(*known)].is_closed = !content.surface_defect;
    return SetMesh(*known, part);
  }
  auto asset = std::make_unique<model::MeshAsset>();
  asset->name = part.name;
  asset->mesh = Scaled(*content.mesh, scale);
  asset->scale = scale;
  asset->mark = part.mark;
  if (content.fit_for_mujoco) {
    asset->file = file;
    asset->output_file = OutputName(path);
  }
  SetMesh(Add(std::move(asset), {path, scale, !content.surface_defect}, hash), part);
}

int Assets::ShareMesh(const model::MeshAsset& mesh, const std::string& name) {
  const std::filesystem::path path = AbsolutePath(mesh.file);
  const std::size_t hash = HashOf(path, mesh.scale) + mesh.attributes.size();
  const auto known = FindIndex(meshes_, hash, [&](std::size_t i) {
    const model::MeshAsset& other = *object_.meshes[i];
    const bool is_same_file = sources_[i].file == path && other.file.empty() == mesh.file.empty();
    return is_same_file && !other.is_hull && other.scale == mesh.scale &&
           other.attributes == mesh.attributes;
  });
  if (known) return *known;
  auto asset = std::make_unique<model::MeshAsset>(mesh);
  asset->name = name;
  if (!path.empty()) asset->output_file = OutputName(path);
  return Add(std::move(asset), {path, mesh.scale, false}, hash);
}

int Assets::Add(std::unique_ptr<model::MeshAsset> mesh, MeshSource source, std::size_t hash) {
  const int index = static_cast<int>(object_.meshes.size());
  object_.meshes.push_back(std::move(mesh));
  sources_.push_back(std::move(source));
  meshes_.emplace(hash, index);
  return index;
}

std::optional<model::MassProperties> Assets::UnitMassOf(const model::Shape& shape, int mesh) {
  if (shape.type != model::GeomType::kMesh) return model::MassOf(shape, 1);
  MeshSource& source = sources_[static_cast<std::size_t>(mesh)];
  if (!source.is_closed) return std::nullopt;
  if (!source.unit_mass) source.unit_mass = model::MassOf(shape, 1);
  return source.unit_mass;
}

std::string Assets::OutputName(const std::filesystem::path& file) {
  const auto [found, is_new] = output_names_.try_emplace(file);
  if (!is_new) return found->second;
  std::string stem = PortableName(file.stem().string());
  if (AbsolutePath(file).parent_path() != AbsolutePath(*folder_ / "file").parent_path())
    stem = fmt::format("{}_{}", ShortStem(stem), assembler_.HashOf(file));
  const std::string extension = PortableName(file.extension().string());
  std::string name = stem + extension;
  // Compares names in lower case, because MuJoCo 2.2 ignores the case of file names.
  for (int i = 2; !taken_names_.insert(diag::LowerCase(name)).second; ++i)
    name = fmt::format("{}_{}{}", stem, i, extension);
  found->second = name;
  return name;
}

void Assets::SumMass(model::Body& body) {
  if (body.explicit_inertial) return;  // an attached file specifies the mass properties
  model::MassProperties sum;
  for (const model::Part& part : body.parts) {
    if (!(part.mass > 0)) continue;
    const model::MassProperties unit =
        part.solid ? *part.solid : *UnitMassOf(part.shape, part.mesh);
    model::MassProperties properties = model::Scaled(unit, part.mass / unit.mass);
    properties.mass = part.mass;
    sum = model::Combine(sum, model::InFrame(part.X_BG, properties));
    body.explicit_inertial |= part.solid.has_value() || part.shape.type == model::GeomType::kMesh;
  }
  body.mass_properties = sum;
}

}  // namespace mjforge::assemble
