#include "mjforge/manifest/exact_json.h"

#include <charconv>
#include <optional>

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include "mjforge/expr/expr.h"

namespace mjforge::manifest {
namespace {

using rapidjson::SizeType;

// Passes everything on, numbers as their values. (RapidJSON 1.1 has an exact reader as well; it
// shifts by 64 bits for a zero with many digits.)
class NumberReader {
 public:
  explicit NumberReader(rapidjson::Document& document) : document_(document) {}

  bool Null() { return document_.Null(); }
  bool Bool(bool value) { return document_.Bool(value); }
  bool Int(int value) { return document_.Int(value); }
  bool Uint(unsigned value) { return document_.Uint(value); }
  bool Int64(std::int64_t value) { return document_.Int64(value); }
  bool Uint64(std::uint64_t value) { return document_.Uint64(value); }
  bool Double(double value) { return document_.Double(value); }
  bool RawNumber(const char* digits, SizeType size, bool) {
    const std::string_view text(digits, size);
    // There is no whole number -0.
    if (text.find_first_of(".eE") == text.npos && text != "-0") {
      if (const auto natural = Whole<std::uint64_t>(text)) return document_.Uint64(*natural);
      if (const auto whole = Whole<std::int64_t>(text)) return document_.Int64(*whole);
    }
    const std::optional<double> number = expr::ParseNumber(text);
    return number && document_.Double(*number);
  }
  bool String(const char* text, SizeType size, bool copy) {
    return document_.String(text, size, copy);
  }
  bool StartObject() { return document_.StartObject(); }
  bool Key(const char* text, SizeType size, bool copy) { return document_.Key(text, size, copy); }
  bool EndObject(SizeType count) { return document_.EndObject(count); }
  bool StartArray() { return document_.StartArray(); }
  bool EndArray(SizeType count) { return document_.EndArray(count); }

 private:
  template <typename Integer>
  static std::optional<Integer> Whole(std::string_view text) {
    Integer value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }

  rapidjson::Document& document_;
};

}  // namespace

bool ParseExactly(std::string_view text, rapidjson::Document& document) {
  constexpr unsigned kFlags =
      rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag;
  rapidjson::MemoryStream bytes(text.data(), text.size());
  rapidjson::EncodedInputStream<rapidjson::UTF8<>, rapidjson::MemoryStream> stream(bytes);
  rapidjson::Reader reader;
  bool is_parsed = false;
  const auto generate = [&](rapidjson::Document& target) {
    NumberReader numbers(target);
    is_parsed = !reader.Parse<kFlags>(stream, numbers).IsError();
    return is_parsed;
  };
  document.Populate(generate);
  return is_parsed;
}

}  // namespace mjforge::manifest
