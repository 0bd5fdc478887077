// Resolution of asset file names by MuJoCo's rules: meshdir, texturedir and strippath.
#include "mjforge/xml/asset_files.h"

#include <system_error>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/xml/well_formed.h"

namespace mjforge::xml {
namespace {

namespace fs = std::filesystem;

/// Values of the attributes of <compiler> that determine the paths of assets.
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
      // Keeps an invalid value in the element, because MuJoCo must reject the file.
      if (*strip != "true" && *strip != "false") continue;
      folders.strip = *strip == "true";
    }
    for (const char* setting : {"meshdir", "texturedir", "strippath"}) section.Remove(setting);
  }
  return folders;
}

/// Returns an absolute path. Resolves symbolic links in the folder's path, but not a link of the
/// file itself, because MuJoCo selects the format by the extension of the file's name.
fs::path Absolute(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  const fs::path folder = fs::weakly_canonical(whole.parent_path(), error);
  return error ? whole : folder / whole.filename();
}

}  // namespace

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
      AddError(findings, UnreadableCode(file), asset.mark,
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

}  // namespace mjforge::xml
