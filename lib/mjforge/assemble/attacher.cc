// Copies bodies of MJCF files into the object, and adapts names, references and indices of the
// copies.

#include "mjforge/assemble/attacher.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mjforge::assemble {

using diag::Code;
using spec::Key;

namespace {

// Returns a name for an element of a section of an MJCF file that has no name there. The number is
// that of the element in the file's section, so that other copies in the object do not change it.
std::string NewName(const std::vector<model::Element>& section, const model::Element& element) {
  std::string name = fmt::format("{}{}", element.tag, &element - section.data());
  while (std::ranges::find(section, name, &model::Element::name) != section.end()) name += '_';
  return name;
}

}  // namespace

// Renames the copied elements of an attachment (a body of an MJCF file), and adapts their indices
// and references.
class Renamer {
 public:
  Renamer(const model::Attachment& attachment, std::string prefix, std::string root)
      : attachment_(attachment), prefix_(std::move(prefix)), root_(std::move(root)) {}

  /// Indices, in the object, of the materials and meshes of the attachment. Each list is indexed by
  /// the index in the attachment.
  std::vector<int> materials;
  std::vector<int> meshes;

  std::string Name(const std::string& own) const { return own.empty() ? own : prefix_ + own; }
  std::string Reference(std::string_view kind, const std::string& own) const {
    const bool is_root = kind.ends_with("body") && own == attachment_.bodies.front().name;
    return is_root ? root_ : prefix_ + own;
  }
  void Rename(model::Element& element) const {
    element.name = Name(element.name);
    for (model::Attribute& attribute : element.attributes) {
      if (attribute.refers.empty()) continue;
      attribute.text = Reference(KindOf(attribute, element), attribute.text);
    }
    for (model::Element& child : element.children) Rename(child);
  }
  void Rename(model::Body& body) const {
    body.name = Name(body.name);
    for (model::Joint& joint : body.joints) joint.name = Name(joint.name);
    for (model::Site& site : body.sites) {
      site.name = Name(site.name);
      site.material = Material(site.material);
    }
    for (model::Element& element : body.elements) Rename(element);
    for (model::Part& part : body.parts) {
      part.name = Name(part.name);
      part.material = Material(part.material);
      if (part.mesh >= 0) part.mesh = meshes[static_cast<std::size_t>(part.mesh)];
    }
  }

 private:
  int Material(int own) const { return own < 0 ? own : materials[static_cast<std::size_t>(own)]; }

  const model::Attachment& attachment_;
  std::string prefix_;
  std::string root_;  // a copy, because Object::bodies, which has the name, grows
};

std::size_t Attacher::Add(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                          const std::string& name, std::size_t index) {
  const spec::Field& field = *entry.Find(Key::kMjcf);
  const std::optional<std::string> file = reader.Text(field);
  std::string body_name;
  if (!reader.ReadOptional(entry, Key::kBody, &FieldReader::Text, body_name) || !file) return 0;
  const spec::Field* asked = entry.Find(Key::kBody) != nullptr ? entry.Find(Key::kBody) : &field;
  const std::filesystem::path path = (scope.values.spec().folder / *file).lexically_normal();
  // Calls Attach() only once per file and body, because each call adds the findings of the file
  // again.
  const auto [found, is_new] = attached_.try_emplace({path, body_name}, nullptr);
  if (is_new && context_.source == nullptr) {
    reader.Report(Code::kAttachNoBody, field,
                  "cannot be read: reading MJCF files is not enabled here");
  } else if (is_new) {
    found->second = context_.source->Attach(path, body_name, asked->value.mark, context_.findings);
  }
  if (found->second == nullptr) return 0;
  const model::Attachment& attachment = *found->second;
  Renamer renamer(attachment, scope.prefix + name + "_", context_.object.bodies[index].name);
  CopyAssets(attachment, renamer);
  const std::size_t parts = CopyBodies(attachment, renamer, index);
  for (const std::string& joint : attachment.root_joints) {
    context_.references.MarkRemoved(renamer.Name(joint), fmt::format("'{}'", *file));
  }
  CopySections(attachment, renamer);
  return parts;
}

void Attacher::CopyAssets(const model::Attachment& attachment, Renamer& renamer) {
  std::vector<int> textures;
  for (const model::Texture& own : attachment.textures) {
    model::Texture texture = own;
    texture.name = renamer.Name(own.name);
    for (model::TextureFile& picture : texture.files)
      picture.output_file = context_.assets.OutputName(picture.file);
    textures.push_back(context_.assets.ShareTexture(own.name, std::move(texture)));
  }
  for (const model::Material& own : attachment.materials) {
    model::Material material = own;
    material.name = renamer.Name(own.name);
    if (own.texture >= 0) material.texture = textures[static_cast<std::size_t>(own.texture)];
    renamer.materials.push_back(context_.materials.Share(own.name, std::move(material)));
  }
  for (const auto& mesh : attachment.meshes) {
    renamer.meshes.push_back(context_.assets.ShareMesh(*mesh, renamer.Name(mesh->name)));
  }
}

std::size_t Attacher::CopyBodies(const model::Attachment& attachment, const Renamer& renamer,
                                 std::size_t index) {
  std::size_t parts = 0;
  for (const model::Body& own : attachment.bodies) {
    model::Body body = own;
    renamer.Rename(body);
    body.attached = static_cast<int>(index);
    for (model::Part& part : body.parts) {
      if (part.mesh >= 0)
        part.shape.mesh = &context_.object.meshes[static_cast<std::size_t>(part.mesh)]->mesh;
    }
    parts += body.parts.size();
    if (&own == &attachment.bodies.front()) {
      model::Body& entry = context_.object.bodies[index];
      body.name = entry.name;
      body.parent = entry.parent;
      body.mark = entry.mark;
      body.joints.clear();
      entry = std::move(body);
    } else {
      body.parent += static_cast<int>(index);
      context_.bodies.emplace(body.name, static_cast<int>(context_.object.bodies.size()));
      context_.object.bodies.push_back(std::move(body));
    }
  }
  return parts;
}

void Attacher::CopySections(const model::Attachment& attachment, const Renamer& renamer) {
  for (const model::Section& section : attachment.sections) {
    std::vector<model::Element>& elements = context_.sections.ElementsOf(*section.info);
    for (const model::Element& own : section.elements) {
      const References::ElementPlace place = {section.info, elements.size()};
      model::Element& element = elements.emplace_back(own);
      if (own.name.empty() && section.info->name != "contact") {
        element.name = NewName(section.elements, own);
      }
      renamer.Rename(element);
      AddReferences(place, own, element);
    }
  }
}

void Attacher::AddReferences(References::ElementPlace place, const model::Element& own,
                             const model::Element& element) {
  for (std::size_t i = 0; i < own.attributes.size(); ++i) {
    const model::Attribute& attribute = own.attributes[i];
    if (attribute.refers.empty()) continue;
    context_.references.Add(
        place, KindOf(attribute, own), element.attributes[i].text, attribute.text,
        fmt::format("{} of {} '{}'", attribute.name, own.tag, own.name), own.mark);
  }
  for (std::size_t i = 0; i < own.children.size(); ++i) {
    AddReferences(place, own.children[i], element.children[i]);
  }
}

}  // namespace mjforge::assemble
