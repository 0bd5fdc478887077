// Implementation of the streaming XML writer: tags and indentation, escaping of texts, numbers in
// three formats.

#include "mjforge/mjcf/element_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::mjcf {
namespace {

// Maximum number of indentation levels, because deeper kinematic chains would consist mostly of
// blanks.
constexpr std::size_t kDeepest = 24;

// True for bytes that must be escaped. A table, because every character of every text is looked up.
constexpr auto kNeedsEscape = [] {
  std::array<bool, 256> needs{};
  for (std::size_t c = 0; c < 0x20; ++c) needs[c] = true;
  for (const char c : {'&', '<', '>', '"', '\x7f'}) needs[static_cast<unsigned char>(c)] = true;
  return needs;
}();

bool NeedsEscape(char c) { return kNeedsEscape[static_cast<unsigned char>(c)]; }

std::string Escaped(std::string_view value) {
  std::string out;
  for (const char c : value) {
    if (!NeedsEscape(c)) {
      out += c;
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += fmt::format("&#{};", static_cast<int>(c));
    }
  }
  return out;
}

char* WriteInteger(char* out, int number) {
  return std::to_chars(out, out + expr::kLongestNumber, number).ptr;
}

// Rounds to whole micrometres, for meshes of at most 10 m. Avoids std::round, which is not inlined.
int Micrometres(double metres) {
  return static_cast<int>(metres * 1e6 + std::copysign(0.5, metres));
}

}  // namespace

ElementWriter::ElementWriter(MjcfDocument& document)
    : text_(document.text), size_(document.text.size()), origins_(document.origins) {}

void ElementWriter::MakeRoom() {
  constexpr std::size_t kStep = 4096;  // bytes; most objects need one or two steps
  text_.resize(size_ + kStep);
}

void ElementWriter::RepeatText(std::size_t begin, std::size_t end) {
  char* const out = Extend(end - begin);
  std::copy_n(text_.data() + begin, end - begin, out);
}

void ElementWriter::WriteLine(std::string_view text) {
  Indent();
  Append(text);
  FinishLine("\n");
}

void ElementWriter::OpenElement(std::string_view tag, diag::SourceMark mark) {
  if (mark) origins_.push_back({line_, mark});
  Indent();
  Append("<");
  Append(tag);
}

void ElementWriter::Indent() {
  const std::size_t count = 2 * std::min(depth_, kDeepest);
  std::fill_n(Extend(count), count, ' ');
}

void ElementWriter::BeginContent() {
  FinishLine(">\n");
  ++depth_;
}

void ElementWriter::EndElement(std::string_view tag) {
  --depth_;
  Indent();
  Append("</");
  Append(tag);
  FinishLine(">\n");
}

void ElementWriter::FinishLine(std::string_view end) {
  Append(end);
  ++line_;
}

void ElementWriter::WriteText(std::string_view name, std::string_view value,
                              std::string_view suffix) {
  if (std::ranges::any_of(value, NeedsEscape)) {
    WriteUnescaped(name, Escaped(value), suffix);
  } else {
    WriteUnescaped(name, value, suffix);
  }
}

void ElementWriter::WriteUnescaped(std::string_view name, std::string_view value,
                                   std::string_view suffix) {
  char* out = Extend(name.size() + value.size() + suffix.size() + 4);
  *out++ = ' ';
  out = std::ranges::copy(name, out).out;
  *out++ = '=';
  *out++ = '"';
  out = std::ranges::copy(value, out).out;
  out = std::ranges::copy(suffix, out).out;
  *out = '"';
}

void ElementWriter::WriteNumbers(std::string_view name, std::span<const double> values,
                                 NumberFormat format) {
  WriteList(name, values, [format](char* out, double number) {
    if (format == NumberFormat::kMicrometres) return WriteInteger(out, Micrometres(number));
    return expr::WriteNumber(out, format == NumberFormat::kExact ? number : FlushNoise(number));
  });
}

void ElementWriter::WriteIntegers(std::string_view name, std::span<const int> values) {
  WriteList(name, values, WriteInteger);
}

// Collects numbers in a buffer, because appending each number to the text would take a third of the
// time of writing a mesh. The name, a word of MJCF, always fits into the buffer.
template <typename T, typename Write>
void ElementWriter::WriteList(std::string_view name, std::span<const T> values,
                              const Write& write) {
  std::array<char, 64 * (expr::kLongestNumber + 1)> buffer;
  const char* const full = buffer.end() - expr::kLongestNumber - 2;  // 2: separator and quote
  char* out = buffer.data();
  *out++ = ' ';
  out = std::ranges::copy(name, out).out;
  *out++ = '=';
  *out++ = '"';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (out > full) {
      Append({buffer.data(), out});
      out = buffer.data();
    }
    if (i > 0) *out++ = ' ';
    out = write(out, values[i]);
  }
  *out++ = '"';
  Append({buffer.data(), out});
}

void ElementWriter::WritePose(const model::Pose& pose) {
  WritePoint("pos", pose.p);
  const Eigen::Quaterniond& q = pose.q;
  if (FlushNoise(q.x()) == 0 && FlushNoise(q.y()) == 0 && FlushNoise(q.z()) == 0) return;
  WriteVector("quat", model::Wxyz(q), 4, NumberFormat::kFlushed);
}

void ElementWriter::WriteAttribute(const model::Attribute& attribute) {
  if (attribute.numbers.empty()) {
    WriteText(attribute.name, attribute.text);
    return;
  }
  // Replaces rounding errors by zero in poses of cameras and lights, which may have been
  // transformed together with their body.
  const bool is_place =
      attribute.name == "pos" || attribute.name == "quat" || attribute.name == "dir";
  if (const std::string_view text = attribute.numbers.text(); !text.empty() && !is_place) {
    WriteUnescaped(attribute.name, text, {});
    return;
  }
  WriteNumbers(attribute.name, {attribute.numbers.data(), attribute.numbers.size()},
               is_place ? NumberFormat::kFlushed : NumberFormat::kExact);
}

}  // namespace mjforge::mjcf
