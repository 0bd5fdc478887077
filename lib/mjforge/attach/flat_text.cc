#include "mjforge/attach/flat_text.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace mjforge::attach {
namespace {

namespace fs = std::filesystem;

constexpr std::array kSectionTags = {"contact", "equality", "tendon", "actuator", "sensor"};
constexpr std::array kBodyTags = {"body", "joint", "freejoint", "geom", "site", "camera", "light"};
constexpr std::array kFileAttributes = {"file",     "fileright", "fileleft", "fileup",
                                        "filedown", "filefront", "fileback"};

void Escape(std::string& text, std::string_view value) {
  for (const char c : value) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
}

void Write(const XmlElement& element, FlatText& out) {
  if (!out.lines.empty()) out.text += '\n';
  out.lines.push_back(&element);
  out.text += '<';
  out.text += element.tag;
  const auto write = [&](std::string_view name, std::string_view value) {
    out.text += fmt::format(" {}=\"", name);
    Escape(out.text, value);
    out.text += '"';
  };
  for (const auto& [name, value] : element.attributes) {
    if (name != "name" || element.made_name.empty()) write(name, value);
  }
  if (!element.made_name.empty()) write("name", element.made_name);
  out.text += '>';
  for (const XmlElement& child : element.children) Write(child, out);
  out.text += fmt::format("</{}>", element.tag);
}

/// Names that begin with a text no name of the file begins with.
class Namer {
 public:
  explicit Namer(const XmlElement& root) {
    while (Uses(root)) prefix_ += '~';
  }

  void Name(XmlElement& element) {
    if (element.Name().empty()) element.made_name = fmt::format("{}{}", prefix_, ++count_);
  }

  void NameBodies(XmlElement& parent) {
    for (XmlElement& child : parent.children) {
      if (std::ranges::find(kBodyTags, child.tag) == kBodyTags.end()) continue;
      Name(child);
      if (child.tag == "body") NameBodies(child);
    }
  }

 private:
  bool Uses(const XmlElement& element) const {
    return element.Name().starts_with(prefix_) ||
           std::ranges::any_of(element.children, [this](const auto& c) { return Uses(c); });
  }

  std::string prefix_ = "~";
  int count_ = 0;
};

/// The compiler's settings of where files are.
struct Folders {
  std::string mesh;
  std::string texture;
  bool strip = false;
};

bool IsAbsolute(const std::string& path) { return path.starts_with('/') || path.starts_with('\\'); }

std::string WithEnd(std::string folder) {
  if (!folder.empty() && !folder.ends_with('/') && !folder.ends_with('\\')) folder += '/';
  return folder;
}

Folders TakeFolders(XmlElement& root) {
  Folders folders;
  for (XmlElement& section : root.children) {
    if (section.tag != "compiler") continue;
    if (const std::string* dir = section.Find("meshdir")) folders.mesh = WithEnd(*dir);
    if (const std::string* dir = section.Find("texturedir")) folders.texture = WithEnd(*dir);
    if (const std::string* strip = section.Find("strippath")) {
      // Another word is MuJoCo's to refuse.
      if (*strip != "true" && *strip != "false") continue;
      folders.strip = *strip == "true";
    }
    for (const char* setting : {"meshdir", "texturedir", "strippath"}) section.Remove(setting);
  }
  return folders;
}

/// The folder of links resolved, the file's own name kept: its ending says what
/// it is.
fs::path Absolute(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  const fs::path folder = fs::weakly_canonical(whole.parent_path(), error);
  return error ? whole : folder / whole.filename();
}

}  // namespace

const XmlElement* FlatText::OnLine(int line) const {
  if (line < 1 || static_cast<std::size_t>(line) > lines.size()) return nullptr;
  return lines[static_cast<std::size_t>(line) - 1];
}

FlatText Flatten(const XmlElement& root) {
  FlatText flat;
  Write(root, flat);
  return flat;
}

void NameElements(XmlElement& root) {
  Namer namer(root);
  for (XmlElement& section : root.children) {
    if (section.tag == "worldbody") namer.NameBodies(section);
    if (std::ranges::find(kSectionTags, section.tag) == kSectionTags.end()) continue;
    for (XmlElement& element : section.children) namer.Name(element);
  }
}

FileNames ResolveFiles(XmlElement& root, const fs::path& folder, diag::Findings& findings) {
  const Folders folders = TakeFolders(root);
  FileNames names;
  const auto resolve = [&](XmlElement& asset, const char* attribute) {
    const std::string* text = asset.Find(attribute);
    if (text == nullptr || text->empty()) return;
    std::string name = folders.strip ? text->substr(text->find_last_of("/\\") + 1) : *text;
    if (!IsAbsolute(name)) {
      name = (asset.tag == "texture" ? folders.texture : folders.mesh) + name;
    }
    const fs::path file = IsAbsolute(name) ? fs::path(name) : folder / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      AddError(findings, diag::Code::kModelFileNotFound, asset.mark,
               fmt::format("cannot read '{}', the {} of {}", file.string(), attribute,
                           asset.Description()));
    }
    const std::string absolute = Absolute(file).string();
    names.emplace(absolute, file.string());
    asset.Set(attribute, absolute);
  };
  for (XmlElement& section : root.children) {
    if (section.tag != "asset") continue;
    for (XmlElement& asset : section.children) {
      for (const char* attribute : kFileAttributes) resolve(asset, attribute);
    }
  }
  return names;
}

std::string FileStem(const std::string& file) {
  const std::string name = file.substr(file.find_last_of("/\\") + 1);
  return name.substr(0, name.find_last_of('.'));
}

}  // namespace mjforge::attach
