#include "mjforge/mjcf/element_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::mjcf {
namespace {

/// Levels of indentation: bodies deep in a chain would be mostly blanks.
constexpr std::size_t kDeepest = 24;

// By byte: every character of every name is asked for.
constexpr auto kNeedsEscape = [] {
  std::array<bool, 256> needs{};
  for (std::size_t c = 0; c < 0x20; ++c) needs[c] = true;
  for (const char c : {'&', '<', '>', '"', '\x7f'}) needs[static_cast<unsigned char>(c)] = true;
  return needs;
}();

bool NeedsEscape(char c) { return kNeedsEscape[static_cast<unsigned char>(c)]; }

template <typename T>
char* WriteInteger(char* out, T number) {
  return std::to_chars(out, out + expr::kLongestNumber, number).ptr;
}

// The nearest whole number of micrometres. (std::round is a call.)
std::int64_t Micrometres(double metres) {
  return static_cast<std::int64_t>(metres * 1e6 + std::copysign(0.5, metres));
}

}  // namespace

ElementWriter::ElementWriter(MjcfDocument& document)
    : text_(document.text), origins_(document.origins) {}

void ElementWriter::Line(std::string_view text) {
  Indent();
  text_ += text;
  Finish("\n");
}

void ElementWriter::Open(std::string_view tag, diag::SourceMark mark) {
  if (mark) origins_.push_back({line_, mark});
  Indent();
  text_ += '<';
  text_ += tag;
}

void ElementWriter::Indent() { text_.append(2 * std::min(depth_, kDeepest), ' '); }

void ElementWriter::Content() {
  Finish(">\n");
  ++depth_;
}

void ElementWriter::End(std::string_view tag) {
  --depth_;
  Indent();
  text_ += "</";
  text_ += tag;
  Finish(">\n");
}

void ElementWriter::Finish(std::string_view end) {
  text_ += end;
  ++line_;
}

// Single characters are put in where they stand; a longer text is a call.
void ElementWriter::Begin(std::string_view name) {
  text_ += ' ';
  text_ += name;
  text_ += '=';
  text_ += '"';
}

void ElementWriter::Text(std::string_view name, std::string_view value) {
  Begin(name);
  Escaped(value);
  text_ += '"';
}

void ElementWriter::Text(std::string_view name, std::string_view value, std::string_view suffix) {
  Begin(name);
  Escaped(value);
  text_ += suffix;
  text_ += '"';
}

void ElementWriter::Escaped(std::string_view value) {
  if (std::ranges::none_of(value, NeedsEscape)) {
    text_ += value;
    return;
  }
  for (const char c : value) {
    if (!NeedsEscape(c)) {
      text_ += c;
    } else if (c == '&') {
      text_ += "&amp;";
    } else if (c == '<') {
      text_ += "&lt;";
    } else if (c == '>') {
      text_ += "&gt;";
    } else if (c == '"') {
      text_ += "&quot;";
    } else {
      text_ += fmt::format("&#{};", static_cast<int>(c));
    }
  }
}

void ElementWriter::Number(std::string_view name, double value) { Numbers(name, {&value, 1}); }

void ElementWriter::Numbers(std::string_view name, std::span<const double> values,
                            Spelling spelling) {
  Begin(name);
  AppendAll(values, [spelling](char* out, double number) {
    if (spelling == Spelling::kMicrometres) return WriteInteger(out, Micrometres(number));
    return expr::WriteNumber(out, spelling == Spelling::kNumber ? number : WithoutNoise(number));
  });
  text_ += '"';
}

void ElementWriter::Integers(std::string_view name, std::span<const int> values) {
  Begin(name);
  AppendAll(values, WriteInteger<int>);
  text_ += '"';
}

// Through a buffer, because appending number by number takes a third of a mesh's time.
template <typename T, typename Write>
void ElementWriter::AppendAll(std::span<const T> values, const Write& write) {
  constexpr std::size_t kMost = 64;  // numbers in the buffer
  std::array<char, kMost*(expr::kLongestNumber + 1)> buffer;
  for (std::size_t i = 0; i < values.size(); i += kMost) {
    char* out = buffer.data();
    for (const T& value : values.subspan(i, std::min(kMost, values.size() - i))) {
      out = write(out, value);
      *out++ = ' ';
    }
    text_.append(buffer.data(), out);
  }
  if (!values.empty()) text_.pop_back();
}

void ElementWriter::Pose(const model::Pose& pose) {
  Point("pos", pose.p);
  const Eigen::Quaterniond& q = pose.q;
  if (WithoutNoise(q.x()) == 0 && WithoutNoise(q.y()) == 0 && WithoutNoise(q.z()) == 0) return;
  Vector("quat", model::Wxyz(q), 4, Spelling::kWithoutNoise);
}

void ElementWriter::Attribute(const model::Attribute& attribute) {
  if (attribute.numbers.empty()) {
    Text(attribute.name, attribute.text);
    return;
  }
  // Cameras and lights are turned and moved with what brings them.
  const bool is_place =
      attribute.name == "pos" || attribute.name == "quat" || attribute.name == "dir";
  Numbers(attribute.name, {attribute.numbers.data(), attribute.numbers.size()},
          is_place ? Spelling::kWithoutNoise : Spelling::kNumber);
}

}  // namespace mjforge::mjcf
