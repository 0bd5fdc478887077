#include "mjforge/engine/flat_text.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/xml_file.h"

namespace mjforge::engine {
namespace {

namespace fs = std::filesystem;

/// `start` is called before each element.
template <typename Start>
void Write(const XmlElement& element, std::string& out, const Start& start) {
  start(element);
  out += '<';
  out += element.tag;
  const auto write = [&](std::string_view name, const std::string& value) {
    // XML cannot carry them there.
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    std::string text = value;
    std::ranges::replace_if(text, is_control, ' ');
    out += fmt::format(" {}=\"{}\"", name, EscapeXml(text));
  };
  for (const auto& [name, value] : element.attributes) {
    if (name != "name" || element.made_name.empty()) write(name, value);
  }
  if (!element.made_name.empty()) write("name", element.made_name);
  out += '>';
  for (const XmlElement& child : element.children) Write(child, out, start);
  out += fmt::format("</{}>", element.tag);
}

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

FlatText Flatten(const XmlElement& root) {
  FlatText flat;
  Write(root, flat.text, [&](const XmlElement& element) {
    if (!flat.lines.empty()) flat.text += '\n';
    flat.lines.push_back(&element);
  });
  return flat;
}

std::string FlattenInPlace(const XmlElement& root) {
  std::string text;
  std::uint32_t line = 1;
  Write(root, text, [&](const XmlElement& element) {
    if (element.mark.file != root.mark.file) return;
    for (; line < element.mark.line; ++line) text += '\n';
  });
  return text;
}

FileNames ResolveFiles(XmlElement& root, const fs::path& folder, diag::Findings& findings) {
  const Folders folders = TakeFolders(root);
  FileNames names;
  const auto resolve = [&](XmlElement& asset, std::string_view attribute) {
    const std::string* text = asset.Find(attribute);
    if (text == nullptr || text->empty()) return;
    std::string name = folders.strip ? text->substr(text->find_last_of("/\\") + 1) : *text;
    if (!IsAbsolute(name)) {
      name = (asset.tag == "texture" ? folders.texture : folders.mesh) + name;
    }
    const fs::path file = IsAbsolute(name) ? fs::path(name) : folder / name;
    std::string why_not;
    if (!bytes::MayRead(file, bytes::kMaxAsset, why_not)) {
      AddError(findings, engine::CodeOfUnread(file), asset.mark,
               fmt::format("cannot read '{}', the {} of {}: {}", file.string(), attribute,
                           asset.Description(), why_not));
    }
    const std::string absolute = Absolute(file).string();
    names.emplace(absolute, file.string());
    asset.Set(attribute, absolute);
  };
  for (XmlElement& section : root.children) {
    if (section.tag != "asset") continue;
    for (XmlElement& asset : section.children) {
      for (const std::string_view attribute : kFileAttributes) resolve(asset, attribute);
    }
  }
  return names;
}

}  // namespace mjforge::engine
