// Writing and reading of the comment at the beginning of a generated file.

#include "mjforge/mjcf/provenance.h"

#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

#include <pugixml.hpp>

namespace mjforge::mjcf {
namespace {

// Format of the comment: `mjforge VERSION key=value ...`, separated by single spaces. In values,
// bytes other than printable ASCII, and those that would end a value or the comment, are written
// as %XX.
constexpr std::string_view kOpening = " mjforge ";
constexpr std::string_view kSetting = "set:";

// Appends a value, with %XX for bytes that need it. Copies the bytes between two escaped bytes at
// once, because appending them one by one would take a twentieth of the time of a small variant.
void AppendEncoded(std::string_view value, std::string& out) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::size_t copied = 0;  // characters of `value` that have been appended
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto byte = static_cast<unsigned char>(value[i]);
    const char before = i > copied ? value[i - 1] : out.back();
    const bool plain = byte > 0x20 && byte < 0x7f && byte != '%' && byte != '=' && byte != '<' &&
                       byte != '>' && !(byte == '-' && before == '-');
    if (plain) continue;
    out += value.substr(copied, i - copied);
    out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    copied = i + 1;
  }
  out += value.substr(copied);
}

void AppendPair(std::string_view key, std::string_view value, std::string& out) {
  out += ' ';
  out += key;
  out += '=';
  AppendEncoded(value, out);
}

template <typename Integer>
bool ReadInteger(std::string_view text, int base, Integer& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc() && end == text.data() + text.size();
}

std::optional<std::string> Decoded(std::string_view text) {
  std::string value;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      value += text[i];
      continue;
    }
    unsigned byte = 0;
    if (i + 2 >= text.size() || !ReadInteger(text.substr(i + 1, 2), 16, byte)) return std::nullopt;
    value += static_cast<char>(byte);
    i += 2;
  }
  return value;
}

// Reads one `key=value` into the provenance; returns false if the word is malformed. Unknown keys
// are ignored, because a later version may write more keys.
bool ReadPair(std::string_view word, Provenance& provenance) {
  if (word.find('=') == std::string_view::npos) return false;
  const std::string_view key = diag::CutAt('=', word);
  const std::optional<std::string> value = Decoded(word);
  if (!value) return false;
  if (key == "seed") return ReadInteger(*value, 10, provenance.seed);
  if (key == "place-seed") return ReadInteger(*value, 10, provenance.place_seed.emplace());
  if (key == "index") return ReadInteger(*value, 10, provenance.index);
  if (key == "spec") provenance.spec = *value;
  if (key == "sha256") provenance.spec_sha256 = *value;
  if (key == "name") provenance.name = *value;
  if (key == "part") provenance.part = *value;
  if (key == "target") provenance.target = *value;
  if (key == "assets") provenance.assets_as = *value;
  if (key == "sampler") provenance.sampler = *value;
  if (key == "batch") return ReadInteger(*value, 10, provenance.batch);
  if (key.starts_with(kSetting)) {
    const std::optional<std::string> name = Decoded(key.substr(kSetting.size()));
    if (!name) return false;
    provenance.settings.emplace_back(*name, *value);
  }
  return true;
}

std::optional<Provenance> ParseComment(std::string_view comment) {
  comment.remove_prefix(kOpening.size());
  if (comment.ends_with(' ')) comment.remove_suffix(1);
  Provenance provenance;
  const std::optional<std::string> version = Decoded(diag::CutAt(' ', comment));
  if (!version) return std::nullopt;
  provenance.version = *version;
  bool has_seed = false;
  bool has_index = false;
  while (!comment.empty()) {
    const std::string_view word = diag::CutAt(' ', comment);
    if (!ReadPair(word, provenance)) return std::nullopt;
    has_seed |= word.starts_with("seed=");
    has_index |= word.starts_with("index=");
  }
  if (!has_seed || !has_index) return std::nullopt;
  return provenance;
}

}  // namespace

void AppendProvenance(const Provenance& provenance, MjcfDocument& document) {
  std::string& out = document.text;
  out += "<!-- mjforge ";
  AppendEncoded(provenance.version, out);
  AppendPair("spec", provenance.spec, out);
  AppendPair("sha256", provenance.spec_sha256, out);
  AppendPair("seed", std::to_string(provenance.seed), out);
  if (provenance.place_seed) AppendPair("place-seed", std::to_string(*provenance.place_seed), out);
  AppendPair("index", std::to_string(provenance.index), out);
  if (!provenance.name.empty()) AppendPair("name", provenance.name, out);
  if (!provenance.part.empty()) AppendPair("part", provenance.part, out);
  if (!provenance.target.empty()) AppendPair("target", provenance.target, out);
  if (!provenance.assets_as.empty()) AppendPair("assets", provenance.assets_as, out);
  if (!provenance.sampler.empty()) AppendPair("sampler", provenance.sampler, out);
  if (provenance.batch != 0) AppendPair("batch", std::to_string(provenance.batch), out);
  for (const auto& [name, value] : provenance.settings) {
    out += ' ';
    out += kSetting;
    AppendEncoded(name, out);
    out += '=';
    AppendEncoded(value, out);
  }
  out += " -->";
}

std::optional<Provenance> ReadProvenance(std::string_view mjcf) {
  pugi::xml_document document;
  // pugixml keeps the nodes before a syntax error, so a broken file still has its comment.
  document.load_buffer(mjcf.data(), mjcf.size(), pugi::parse_default | pugi::parse_comments);
  for (const pugi::xml_node node : document.children()) {
    if (node.type() != pugi::node_comment) continue;
    const std::string_view comment = node.value();
    if (comment.starts_with(kOpening)) return ParseComment(comment);
  }
  return std::nullopt;
}

}  // namespace mjforge::mjcf
