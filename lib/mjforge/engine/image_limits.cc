// Adds up the pixels of the images that an MJCF text refers to.
#include "mjforge/engine/image_limits.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"

namespace mjforge::engine {
namespace {

namespace fs = std::filesystem;

/// The images of a text and of all files that it includes, which MuJoCo 2.2 finds relative to the
/// folder of the text.
class ImageScan {
 public:
  ImageScan(std::string_view text, fs::path folder) : text_(text), folder_(std::move(folder)) {
    Add(text);
    for (std::size_t i = 0; i < documents_.size(); ++i) {
      for (const auto& found : documents_[i]->select_nodes("//*")) {
        if (diag::LowerCase(found.node().name()) == "include")
          Include(found.node().attribute("file").value());
      }
      for (const auto& found : documents_[i]->select_nodes("/*/compiler")) Set(found.node());
    }
  }

  std::optional<ImageFault> Find() const {
    std::uint64_t pixels = 0;
    for (const auto& document : documents_) {
      for (const auto& found : document->select_nodes("//asset/texture | //asset/hfield")) {
        pixels = std::min(pixels + PixelsOf(found.node()), 2 * bytes::kMaxPixels);
        if (pixels > bytes::kMaxPixels) return FaultOf(found.node(), document == documents_[0]);
      }
    }
    return std::nullopt;
  }

 private:
  void Add(std::string_view text) {
    documents_.push_back(std::make_unique<pugi::xml_document>());
    documents_.back()->load_buffer(text.data(), text.size());
  }

  void Include(const std::string& name) {
    std::string why_not;
    if (!included_.insert(name).second) return;
    if (const auto text = bytes::Read(folder_ / name, bytes::kMaxMjcf, why_not)) Add(*text);
  }

  void Set(const pugi::xml_node& compiler) {
    const auto set = [&](const char* name, std::string& value) {
      if (const auto attribute = compiler.attribute(name)) value = attribute.value();
    };
    set("texturedir", texture_folder_);
    set("meshdir", mesh_folder_);
    set("strippath", strip_path_);
  }

  std::uint64_t PixelsOf(const pugi::xml_node& asset) const {
    const std::string_view builtin = asset.attribute("builtin").value();
    if (!builtin.empty() && builtin != "none") {
      return std::uint64_t{asset.attribute("width").as_uint()} *
             asset.attribute("height").as_uint();
    }
    const bool is_texture = std::string_view(asset.name()) == "texture";
    std::uint64_t pixels = 0;
    for (const pugi::xml_attribute& attribute : asset.attributes()) {
      if (!std::string_view(attribute.name()).starts_with("file")) continue;
      std::string name = attribute.value();
      if (strip_path_ == "true") name.erase(0, name.find_last_of("/\\") + 1);
      const fs::path file = folder_ / (is_texture ? texture_folder_ : mesh_folder_) / name;
      std::string why_not;
      pixels += std::min(bytes::PngPixels(file, why_not).value_or(0), 2 * bytes::kMaxPixels);
    }
    return pixels;
  }

  ImageFault FaultOf(const pugi::xml_node& asset, bool is_in_text) const {
    const auto offset =
        is_in_text ? static_cast<std::size_t>(std::max<std::ptrdiff_t>(asset.offset_debug(), 0))
                   : 0;
    const std::string_view before = text_.substr(0, offset);
    const std::string_view name = asset.attribute("name").value();
    return {1 + static_cast<int>(std::ranges::count(before, '\n')),
            fmt::format("with {}{} the pictures have more than {} pixels", asset.name(),
                        name.empty() ? "" : fmt::format(" '{}'", name), bytes::kMaxPixels)};
  }

  std::string_view text_;
  fs::path folder_;
  std::deque<std::unique_ptr<pugi::xml_document>> documents_;  // the first is that of the text
  std::set<std::string> included_;
  std::string texture_folder_;
  std::string mesh_folder_;
  std::string strip_path_;
};

}  // namespace

std::optional<ImageFault> FindOversizedImage(std::string_view text, const fs::path& folder) {
  return ImageScan(text, folder).Find();
}

}  // namespace mjforge::engine
