// Streaming XML writer: tags, escaped texts, numbers in three formats.

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

// Maximum number of indentation levels; without it, deep kinematic chains would be mostly blanks.
constexpr std::size_t kDeepest = 24;

// Table by byte, because every character of every text is looked up.
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

// Rounds to whole micrometres. (std::round is not inlined.)
std::int64_t Micrometres(double metres) {
  return static_cast<std::int64_t>(metres * 1e6 + std::copysign(0.5, metres));
}

}  // namespace

ElementWriter::ElementWriter(MjcfDocument& document)
    : text_(document.text), origins_(document.origins) {}

void ElementWriter::WriteLine(std::string_view text) {
  Indent();
  Append(text);
  FinishLine("\n");
}

void ElementWriter::OpenElement(std::string_view tag, diag::SourceMark mark) {
  if (mark) origins_.push_back({line_, mark});
  Indent();
  pending_.push_back('<');
  Append(tag);
}

void ElementWriter::Indent() {
  for (std::size_t i = 0; i < std::min(depth_, kDeepest); ++i) Append("  ");
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
  Flush();
  ++line_;
}

void ElementWriter::Flush() {
  text_.append(pending_.data(), pending_.size());
  pending_.clear();
}

void ElementWriter::RepeatText(std::size_t begin, std::size_t end) {
  Flush();
  text_.append(text_, begin, end - begin);
}

void ElementWriter::BeginAttribute(std::string_view name) {
  pending_.push_back(' ');
  Append(name);
  Append("=\"");
}

void ElementWriter::WriteText(std::string_view name, std::string_view value,
                              std::string_view suffix) {
  BeginAttribute(name);
  AppendEscaped(value);
  Append(suffix);
  pending_.push_back('"');
}

void ElementWriter::AppendEscaped(std::string_view value) {
  if (std::ranges::none_of(value, NeedsEscape)) return Append(value);
  for (const char c : value) {
    if (!NeedsEscape(c)) {
      pending_.push_back(c);
    } else if (c == '&') {
      Append("&amp;");
    } else if (c == '<') {
      Append("&lt;");
    } else if (c == '>') {
      Append("&gt;");
    } else if (c == '"') {
      Append("&quot;");
    } else {
      fmt::format_to(fmt::appender(pending_), "&#{};", static_cast<int>(c));
    }
  }
}

void ElementWriter::WriteNumbers(std::string_view name, std::span<const double> values,
                                 NumberFormat format) {
  WriteList(name, values, [format](char* out, double number) {
    if (format == NumberFormat::kMicrometres) return WriteInteger(out, Micrometres(number));
    return expr::WriteNumber(out, format == NumberFormat::kExact ? number : FlushNoise(number));
  });
}

void ElementWriter::WriteIntegers(std::string_view name, std::span<const int> values) {
  WriteList(name, values, WriteInteger<int>);
}

template <typename T, typename Write>
void ElementWriter::WriteList(std::string_view name, std::span<const T> values,
                              const Write& write) {
  constexpr std::size_t kMostPending = 4096;  // bytes; the list of a mesh has millions
  BeginAttribute(name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (pending_.size() > kMostPending) Flush();
    if (i > 0) pending_.push_back(' ');
    const std::size_t size = pending_.size();
    pending_.resize(size + expr::kLongestNumber);
    const char* const end = write(pending_.data() + size, values[i]);
    pending_.resize(static_cast<std::size_t>(end - pending_.data()));
  }
  pending_.push_back('"');
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
  // Poses of cameras and lights were transformed with their body, which leaves rounding errors.
  const bool is_place =
      attribute.name == "pos" || attribute.name == "quat" || attribute.name == "dir";
  WriteNumbers(attribute.name, {attribute.numbers.data(), attribute.numbers.size()},
               is_place ? NumberFormat::kFlushed : NumberFormat::kExact);
}

}  // namespace mjforge::mjcf
