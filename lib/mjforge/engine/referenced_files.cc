// Searches an MJCF text and its included files for references to unsafe files, for faulty meshes,
// and for too many pixels.
#include "mjforge/engine/referenced_files.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <map>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::engine {
namespace {

namespace fs = std::filesystem;

/// An MJCF text with all files that it includes. Finds the first faulty reference or mesh. Relative
/// file names, also those in included files, are relative to the folder of the text, as in MuJoCo
/// 2.2.
class FileScan {
 public:
  FileScan(std::string_view text, fs::path folder) : text_(text), folder_(std::move(folder)) {
    Add(text, {});
    for (std::size_t i = 0; i < documents_.size(); ++i) {
      for (const auto& found : documents_[i].xml->select_nodes("//*")) {
        if (IsInclude(found.node()))
          Include(FileOf(found.node()), i == 0 ? found.node() : documents_[i].include);
      }
    }
    ReadSettings(documents_[0].xml->document_element());
  }

  std::optional<FileFault> Find() const {
    std::uint64_t pixels = 0;
    for (const Document& document : documents_) {
      for (const auto& found : document.xml->select_nodes("//*")) {
        const pugi::xml_node& element = found.node();
        std::optional<FileFault> fault = FindUnreadable(element);
        if (!fault && HasFaces(element)) fault = FindBadMesh(element);
        if (!fault && IsImage(element)) {
          pixels = std::min(pixels + PixelsOf(element), 2 * bytes::kMaxPixels);
          if (pixels > bytes::kMaxPixels) fault = TooManyPixels(element);
        }
        if (!fault) continue;
        SetPlace(*fault, document.include ? document.include : element);
        return fault;
      }
    }
    return std::nullopt;
  }

 private:
  struct Document {
    std::unique_ptr<pugi::xml_document> xml;
    pugi::xml_node include;  // `<include>` in the text that leads to this file; null for the text
  };

  void Add(std::string_view text, const pugi::xml_node& include) {
    documents_.push_back({std::make_unique<pugi::xml_document>(), include});
    documents_.back().xml->load_buffer(text.data(), text.size());
  }

  void Include(const std::string& name, const pugi::xml_node& include) {
    std::string why_not;
    if (included_.contains(name)) return;
    const auto text = bytes::Read(folder_ / name, bytes::kMaxMjcf, why_not);
    if (text) Add(*text, include);
    included_[name] = text ? documents_.back().xml.get() : nullptr;
  }

  /// Reads the settings of `<compiler>` elements in the order of MuJoCo, which replaces each
  /// include by the elements of its file. The last setting counts.
  void ReadSettings(const pugi::xml_node& root) {
    for (const pugi::xml_node& section : root.children()) {
      if (std::string_view(section.name()) == "compiler") Set(section);
      if (!IsInclude(section)) continue;
      // MuJoCo rejects a second include of a file, which may be a cycle.
      const pugi::xml_document* included = std::exchange(included_[FileOf(section)], nullptr);
      if (included != nullptr) ReadSettings(included->document_element());
    }
  }

  void Set(const pugi::xml_node& compiler) {
    const auto set = [&](const char* name, std::string& value) {
      if (const auto attribute = compiler.attribute(name)) value = attribute.value();
    };
    set("texturedir", texture_folder_);
    set("meshdir", mesh_folder_);
    set("strippath", strip_path_);
  }

  static bool IsInclude(const pugi::xml_node& element) { return xml::IsIncludeTag(element.name()); }

  static std::string FileOf(const pugi::xml_node& include) {
    return include.attribute("file").value();
  }

  /// Returns true for assets, also in a file that is included within `<asset>`.
  static bool IsAsset(const pugi::xml_node& element) {
    const std::string_view parent = element.parent().name();
    if (parent == "asset") return true;
    constexpr std::string_view kAssets[] = {"mesh", "texture", "hfield", "skin"};
    return parent != "mujoco" && element.parent().parent() == element.root() &&
           std::ranges::find(kAssets, element.name()) != std::end(kAssets);
  }

  static bool IsImage(const pugi::xml_node& element) {
    const std::string_view tag = element.name();
    return (tag == "texture" || tag == "hfield") && IsAsset(element);
  }

  /// Returns true for meshes and skins. Skins are below `<deformable>` in MuJoCo 3.
  static bool HasFaces(const pugi::xml_node& element) {
    const std::string_view tag = element.name();
    if (tag == "skin" && std::string_view(element.parent().name()) == "deformable") return true;
    return (tag == "mesh" || tag == "skin") && IsAsset(element);
  }

  /// Returns the paths of the files that an element names.
  std::vector<fs::path> FilesOf(const pugi::xml_node& element) const {
    const bool is_asset = IsAsset(element);
    const bool is_texture = std::string_view(element.name()) == "texture";
    std::vector<fs::path> files;
    for (const pugi::xml_attribute& attribute : element.attributes()) {
      if (!std::string_view(attribute.name()).starts_with("file")) continue;
      std::string name = attribute.value();
      if (is_asset && strip_path_ == "true") name.erase(0, name.find_last_of("/\\") + 1);
      if (name.empty()) continue;
      const std::string& asset_folder = is_texture ? texture_folder_ : mesh_folder_;
      files.push_back(is_asset ? folder_ / asset_folder / name : folder_ / name);
    }
    return files;
  }

  std::optional<FileFault> FindUnreadable(const pugi::xml_node& element) const {
    for (const fs::path& file : FilesOf(element)) {
      std::error_code error;
      std::string why_not;
      if (!fs::exists(file, error) || bytes::MayRead(file, bytes::kMaxAsset, why_not)) continue;
      return FileFault{.message = fmt::format("cannot read '{}', the file of {}: {}", file.string(),
                                              Description(element), why_not)};
    }
    return std::nullopt;
  }

  /// Returns the first fault in the files or in the inline numbers (`vertex`, `face`, ...) of a
  /// mesh or skin. A file of an unknown format is no fault here, because MuJoCo reports the format.
  std::optional<FileFault> FindBadMesh(const pugi::xml_node& mesh) const {
    std::size_t vertices = 0;
    for (const fs::path& file : FilesOf(mesh)) {
      std::string why_not;
      const auto format = FormatOf(mesh, file);
      const auto content = format ? bytes::Read(file, bytes::kMaxAsset, why_not) : std::nullopt;
      if (!content) continue;
      const mesh_data::Check check = mesh_data::CheckFile(*format, *content);
      if (!check.fault.empty()) {
        return FileFault{.code = diag::Code::kModelBadMesh,
                         .message = fmt::format("cannot read '{}', the file of {}: {}",
                                                file.string(), Description(mesh), check.fault)};
      }
      vertices = check.vertices;
    }
    const std::string fault = mesh_data::FindFault({.vertex = mesh.attribute("vertex").value(),
                                                    .normal = mesh.attribute("normal").value(),
                                                    .texcoord = mesh.attribute("texcoord").value(),
                                                    .face = mesh.attribute("face").value(),
                                                    .file_vertices = vertices});
    if (fault.empty()) return std::nullopt;
    return FileFault{.code = diag::Code::kModelBadMesh,
                     .message = fmt::format("{}: {}", Description(mesh), fault)};
  }

  /// Returns the format of a mesh file. Releases from 2.3.7 on prefer `content_type`, "model/obj",
  /// to the file's name.
  static std::optional<mesh_data::Format> FormatOf(const pugi::xml_node& mesh,
                                                   const fs::path& file) {
    const auto format = mesh_data::FormatOf(mesh.attribute("content_type").value());
    return format ? format : mesh_data::FormatOf(file.string());
  }

  std::uint64_t PixelsOf(const pugi::xml_node& image) const {
    const std::string_view builtin = image.attribute("builtin").value();
    if (!builtin.empty() && builtin != "none") {
      return std::uint64_t{image.attribute("width").as_uint()} *
             image.attribute("height").as_uint();
    }
    std::uint64_t pixels = 0;
    for (const fs::path& file : FilesOf(image)) {
      std::string why_not;
      pixels += std::min(bytes::PngPixels(file, why_not).value_or(0), 2 * bytes::kMaxPixels);
    }
    return pixels;
  }

  static std::string Description(const pugi::xml_node& element) {
    const std::string_view name = element.attribute("name").value();
    return fmt::format("{}{}", element.name(), name.empty() ? "" : fmt::format(" '{}'", name));
  }

  static FileFault TooManyPixels(const pugi::xml_node& image) {
    return {.code = diag::Code::kModelBadTexture,
            .message = fmt::format("with {} the pictures have more than {} pixels",
                                   Description(image), bytes::kMaxPixels)};
  }

  void SetPlace(FileFault& fault, const pugi::xml_node& element) const {
    // pugixml returns the offset of the tag's name, which is after the character '<'.
    fault.offset =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug() - 1, 0));
    fault.line = 1 + static_cast<int>(std::ranges::count(text_.substr(0, fault.offset), '\n'));
  }

  std::string_view text_;
  fs::path folder_;
  std::deque<Document> documents_;                             // first: the MJCF text
  std::map<std::string, const pugi::xml_document*> included_;  // by name; null: done
  std::string texture_folder_;
  std::string mesh_folder_;
  std::string strip_path_;
};

}  // namespace

std::optional<FileFault> FindFileFault(std::string_view text, const fs::path& folder) {
  return FileScan(text, folder).Find();
}

}  // namespace mjforge::engine
