// A JSON parser whose numbers are correctly rounded: RapidJSON reads the structure, expr the
// numbers.

#include "mjforge/manifest/exact_json.h"

#include <charconv>
#include <optional>

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include "mjforge/expr/expr.h"

namespace mjforge::manifest {
namespace {

// A document whose numbers are parsed by expr::ParseNumber. RapidJSON 1.1 has an exact reader as
// well, but its behaviour is undefined (a shift by 64 bits) for a zero with many digits.
class ExactDocument : public rapidjson::Document {
 public:
  bool RawNumber(const char* digits, rapidjson::SizeType size, bool) {
    const std::string_view text(digits, size);
    // No integer type has a -0.
    if (text.find_first_of(".eE") == text.npos && text != "-0") {
      if (const auto natural = Whole<std::uint64_t>(text)) return Uint64(*natural);
      if (const auto whole = Whole<std::int64_t>(text)) return Int64(*whole);
    }
    const std::optional<double> number = expr::ParseNumber(text);
    return number && Double(*number);
  }

 private:
  template <typename Integer>
  static std::optional<Integer> Whole(std::string_view text) {
    Integer value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }
};

}  // namespace

bool ParseExactly(std::string_view text, rapidjson::Document& document) {
  constexpr unsigned kFlags =
      rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag;
  rapidjson::MemoryStream bytes(text.data(), text.size());
  rapidjson::EncodedInputStream<rapidjson::UTF8<>, rapidjson::MemoryStream> stream(bytes);
  rapidjson::Reader reader;
  ExactDocument exact;
  bool is_parsed = false;
  const auto generate = [&](rapidjson::Document&) {
    is_parsed = !reader.Parse<kFlags>(stream, exact).IsError();
    return is_parsed;
  };
  exact.Populate(generate);
  document.Swap(exact);
  return is_parsed;
}

}  // namespace mjforge::manifest
