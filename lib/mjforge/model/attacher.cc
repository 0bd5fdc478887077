// Copies of attached bodies: names, references, materials and meshes as the object has them.

#include "mjforge/model/attacher.h"

#include <utility>

#include <fmt/format.h>

namespace mjforge::model {

using diag::Code;
using spec::Key;

// Renames the copies of an attachment's elements, and replaces their indices and references.
class Renamer {
 public:
  Renamer(const Attachment& attachment, std::string prefix, std::string root)
      : attachment_(attachment), prefix_(std::move(prefix)), root_(std::move(root)) {}

  /// Indices of materials and meshes in the object, by their index in the attachment.
  std::vector<int> materials;
  std::vector<int> meshes;

  std::string Name(const std::string& own) const { return own.empty() ? own : prefix_ + own; }
  std::string Reference(std::string_view kind, const std::string& own) const {
    const bool is_root = kind.ends_with("body") && own == attachment_.bodies.front().name;
    return is_root ? root_ : prefix_ + own;
  }
  void Rename(Element& element) const {
    element.name = Name(element.name);
    for (Attribute& attribute : element.attributes) {
      if (attribute.refers.empty()) continue;
      attribute.text = Reference(KindOf(attribute, element), attribute.text);
    }
    for (Element& child : element.children) Rename(child);
  }
  void Rename(Body& body) const {
    body.name = Name(body.name);
    for (Joint& joint : body.joints) joint.name = Name(joint.name);
    for (Site& site : body.sites) {
      site.name = Name(site.name);
      site.material = Material(site.material);
    }
    for (Element& element : body.elements) Rename(element);
    for (Part& part : body.parts) {
      part.name = Name(part.name);
      part.material = Material(part.material);
      if (part.mesh >= 0) part.mesh = meshes[static_cast<std::size_t>(part.mesh)];
    }
  }

 private:
  int Material(int own) const { return own < 0 ? own : materials[static_cast<std::size_t>(own)]; }

  const Attachment& attachment_;
  std::string prefix_;
  std::string root_;  // copied, because Object::bodies grows meanwhile
};

std::size_t Attacher::Add(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                          const std::string& name, std::size_t index) {
  const spec::Field& field = *entry.Find(Key::kMjcf);
  const std::optional<std::string> file = reader.Text(field);
  std::optional<std::string> body_name = std::string();
  if (const spec::Field* body = entry.Find(Key::kBody)) body_name = reader.Text(*body);
  if (!file || !body_name) return 0;
  const spec::Field* asked = entry.Find(Key::kBody) != nullptr ? entry.Find(Key::kBody) : &field;
  const std::filesystem::path path = (scope.values.spec().folder / *file).lexically_normal();
  // The source is asked once per object and body, because it adds its findings every time.
  const auto [found, is_new] = attached_.try_emplace({path, *body_name}, nullptr);
  if (is_new && source_ == nullptr) {
    reader.Report(Code::kAttachNoBody, field,
                  "cannot be read: reading MJCF files is not enabled here");
  } else if (is_new) {
    found->second = source_->Attach(path, *body_name, asked->value.mark, findings_);
  }
  if (found->second == nullptr) return 0;
  const Attachment& attachment = *found->second;
  Renamer renamer(attachment, scope.prefix + name + "_", object_.bodies[index].name);
  CopyAssets(attachment, renamer);
  const std::size_t parts = CopyBodies(attachment, renamer, index);
  for (const std::string& joint : attachment.root_joints) {
    references_.MarkRemoved(renamer.Name(joint), fmt::format("'{}'", *file));
  }
  CopySections(attachment, renamer);
  return parts;
}

void Attacher::CopyAssets(const Attachment& attachment, Renamer& renamer) {
  std::vector<int> textures;
  for (const Texture& own : attachment.textures) {
    Texture texture = own;
    texture.name = renamer.Name(own.name);
    for (TextureFile& picture : texture.files)
      picture.output_file = assets_.OutputName(picture.file);
    textures.push_back(assets_.ShareTexture(own.name, std::move(texture)));
  }
  for (const Material& own : attachment.materials) {
    Material material = own;
    material.name = renamer.Name(own.name);
    if (own.texture >= 0) material.texture = textures[static_cast<std::size_t>(own.texture)];
    renamer.materials.push_back(materials_.Share(own.name, std::move(material)));
  }
  for (const auto& mesh : attachment.meshes) {
    renamer.meshes.push_back(assets_.ShareMesh(*mesh, renamer.Name(mesh->name)));
  }
}

std::size_t Attacher::CopyBodies(const Attachment& attachment, const Renamer& renamer,
                                 std::size_t index) {
  std::size_t parts = 0;
  for (const Body& own : attachment.bodies) {
    Body body = own;
    renamer.Rename(body);
    body.attached = static_cast<int>(index);
    for (Part& part : body.parts) {
      if (part.mesh >= 0)
        part.shape.mesh = &object_.meshes[static_cast<std::size_t>(part.mesh)]->mesh;
    }
    parts += body.parts.size();
    if (&own == &attachment.bodies.front()) {
      Body& entry = object_.bodies[index];
      body.name = entry.name;
      body.parent = entry.parent;
      body.mark = entry.mark;
      body.joints.clear();
      entry = std::move(body);
    } else {
      body.parent += static_cast<int>(index);
      bodies_.emplace(body.name, static_cast<int>(object_.bodies.size()));
      object_.bodies.push_back(std::move(body));
    }
  }
  return parts;
}

void Attacher::CopySections(const Attachment& attachment, const Renamer& renamer) {
  for (const Section& section : attachment.sections) {
    std::vector<Element>& elements = sections_.ElementsOf(*section.info);
    for (const Element& own : section.elements) {
      const References::ElementPlace place = {section.info, elements.size()};
      Element& element = elements.emplace_back(own);
      if (own.name.empty() && section.info->name != "contact") {
        element.name = fmt::format("{}{}", own.tag, place.position);
      }
      renamer.Rename(element);
      AddReferences(place, own, element);
    }
  }
}

void Attacher::AddReferences(References::ElementPlace place, const Element& own,
                             const Element& element) {
  for (std::size_t i = 0; i < own.attributes.size(); ++i) {
    const Attribute& attribute = own.attributes[i];
    if (attribute.refers.empty()) continue;
    references_.Add(place, KindOf(attribute, own), element.attributes[i].text, attribute.text,
                    fmt::format("{} of {} '{}'", attribute.name, own.tag, own.name), own.mark);
  }
  for (std::size_t i = 0; i < own.children.size(); ++i) {
    AddReferences(place, own.children[i], element.children[i]);
  }
}

}  // namespace mjforge::model
