// A JSON parser whose numbers are correctly rounded: RapidJSON reads the structure, and the library
// `expr` reads the numbers.

#include "mjforge/manifest/exact_json.h"

#include <charconv>
#include <optional>
#include <string>

#include <rapidjson/reader.h>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::manifest {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// A document whose numbers are parsed by expr::ParseNumber. RapidJSON 1.1 has an exact reader as
// well, but its behaviour is undefined (a shift by 64 bits) for a zero with many digits.
class ExactDocument : public rapidjson::Document {
 public:
  using rapidjson::Document::Document;

  bool StartObject() { return IsNotTooDeep() && rapidjson::Document::StartObject(); }
  bool StartArray() { return IsNotTooDeep() && rapidjson::Document::StartArray(); }
  bool EndObject(rapidjson::SizeType count) {
    --depth_;
    return rapidjson::Document::EndObject(count);
  }
  bool EndArray(rapidjson::SizeType count) {
    --depth_;
    return rapidjson::Document::EndArray(count);
  }
  bool RawNumber(const char* digits, rapidjson::SizeType size, bool) {
    const std::string_view text(digits, size);
    // Reads -0 as a double, because integers have no negative zero.
    if (text.find_first_of(".eE") == text.npos && text != "-0") {
      if (const auto natural = Whole<std::uint64_t>(text)) return Uint64(*natural);
      if (const auto whole = Whole<std::int64_t>(text)) return Int64(*whole);
    }
    const std::optional<double> number = expr::ParseNumber(text);
    return number && Double(*number);
  }

 private:
  bool IsNotTooDeep() { return ++depth_ <= diag::kMaxJsonDepth; }

  template <typename Integer>
  static std::optional<Integer> Whole(std::string_view text) {
    Integer value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }

  int depth_ = 0;
};

}  // namespace

bool ParseExactly(std::string& text, rapidjson::Document& document) {
  constexpr unsigned kFlags = rapidjson::kParseInsituFlag | rapidjson::kParseNumbersAsStringsFlag;
  const std::size_t start = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  rapidjson::InsituStringStream stream(text.data() + start);
  rapidjson::Reader reader;  // recurses at most kMaxJsonDepth times, because ExactDocument stops it
  ExactDocument exact(&document.GetAllocator());
  bool is_parsed = false;
  const auto generate = [&](rapidjson::Document&) {
    is_parsed = !reader.Parse<kFlags>(stream, exact).IsError() &&
                start + stream.Tell() ==
                    text.size();  // false if a zero byte within the text ended the parsing
    return is_parsed;
  };
  exact.Populate(generate);
  document.Swap(exact);
  return is_parsed;
}

}  // namespace mjforge::manifest
