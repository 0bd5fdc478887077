// Conversion of numbers to text (ten digits, or shortest exact text) and of text to numbers.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

constexpr int kDigits = 10;  // significant digits in MJCF files: 0.1 nm in lengths of 0.1 m to 1 m

// Powers of ten up to 10^22, which are exact as doubles.
constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kLargestPower = static_cast<int>(kPowers.size()) - 1;

// The decimal number `digits` * 10^(exponent - 9). `digits` has ten decimal digits; `exponent` is
// the power of ten of the first of them.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
};

// Returns `magnitude` * 10^(9 - exponent), which has ten digits before the point if `exponent` is
// the decimal exponent of `magnitude`. Returns nullopt if the power of ten is not exact as a
// double. Only the last operation rounds, so the error is at most half a unit in the last place:
// about 1e-6 for a result below 1e10.
std::optional<double> Scaled(double magnitude, int exponent) {
  const int shift = kDigits - 1 - exponent;
  if (shift >= 0 && shift <= kLargestPower) return magnitude * kPowers[static_cast<size_t>(shift)];
  if (shift < 0 && -shift <= kLargestPower) return magnitude / kPowers[static_cast<size_t>(-shift)];
  return std::nullopt;
}

// Returns `magnitude` correctly rounded to ten digits. Returns nullopt if the rounding is
// uncertain, because the power of ten is not exact, or because the fraction to be rounded is too
// close to one half.
std::optional<Decimal> Rounded(double magnitude) {
  const int binary_exponent =
      static_cast<int>((std::bit_cast<std::uint64_t>(magnitude) >> 52) & 0x7ff) - 1023;
  // The decimal exponent is floor(e log10(2)) or one more, where e is the binary exponent.
  // 78913 / 2^18 approximates log10(2).
  int exponent = (binary_exponent * 78913) >> 18;
  std::optional<double> scaled = Scaled(magnitude, exponent);
  if (scaled && *scaled >= kPowers[kDigits]) scaled = Scaled(magnitude, ++exponent);
  if (!scaled) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(*scaled);
  const double rest = *scaled - static_cast<double>(whole);
  constexpr double kDoubt = 1e-5;  // ten times the error of Scaled()
  if (std::abs(rest - 0.5) < kDoubt) return std::nullopt;
  Decimal decimal{whole + (rest > 0.5 ? 1u : 0u), exponent};
  if (decimal.digits == 10'000'000'000u) decimal = {1'000'000'000u, exponent + 1};
  return decimal;
}

// Returns the eight digits of a number below 10^8, one per byte, the first digit in the lowest
// byte. Each step splits all parts into halves: 4 + 4 digits, then 2 + 2, then 1 + 1. Source: P.
// Khuong, "How to print integers really fast", 2017.
std::uint64_t EightDigits(std::uint64_t number) {
  const std::uint64_t fours = number / 10'000 | (number % 10'000) << 32;
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x0000'007f'0000'007f;
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (twos * 103 >> 10) & 0x000f'000f'000f'000f;
  return tens | (twos - 10 * tens) << 8;
}

// The 16 decimal digits of a number below 10^16, one per byte. The first digit is in the lowest
// byte of `high`; on a little-endian processor, storing both words therefore writes the digits in
// order.
static_assert(std::endian::native == std::endian::little);
struct Digits {
  std::uint64_t high;
  std::uint64_t low;

  explicit Digits(std::uint64_t number)
      : high(EightDigits(number / 100'000'000)), low(EightDigits(number % 100'000'000)) {}

  /// Returns the count of digits up to the last digit that is not zero.
  std::size_t count() const {
    const int zeros = low != 0 ? std::countl_zero(low) : 64 + std::countl_zero(high);
    return static_cast<std::size_t>(16 - zeros / 8);
  }
  /// Writes all 16 digits.
  void Write(char* out) const {
    constexpr std::uint64_t kZeros = 0x3030'3030'3030'3030;  // '0' eight times
    const std::uint64_t words[] = {high | kZeros, low | kZeros};
    std::memcpy(out, &words[0], 8);
    std::memcpy(out + 8, &words[1], 8);
  }
};

// Writes the digits as a number without an exponent ("0.00123", "1230"). `exponent`, from -4 to 15,
// is the power of ten of the first digit. Returns the end of the text; some bytes after the end are
// overwritten.
char* WritePositional(char* out, const Digits& digits, int exponent) {
  if (exponent < 0) {
    constexpr std::array kStart = {'0', '.', '0', '0', '0', '0'};
    out = std::copy(kStart.begin(), kStart.end(), out) - 5 - exponent;
    digits.Write(out);
    return out + digits.count();
  }
  std::array<char, 32> zeros_after;
  digits.Write(zeros_after.data());
  std::memset(&zeros_after[16], '0', 16);
  const std::size_t before = static_cast<std::size_t>(exponent) + 1;
  digits.Write(out);
  out += before;
  if (digits.count() <= before) return out;
  *out++ = '.';
  std::memcpy(out, &zeros_after[before], 16);
  return out + (digits.count() - before);
}

char* WriteScientific(char* out, const Digits& digits, int exponent) {
  std::array<char, 16> all;
  digits.Write(all.data());
  *out++ = all[0];
  if (digits.count() > 1) *out++ = '.';
  out = std::copy_n(&all[1], digits.count() - 1, out);
  *out++ = 'e';
  *out++ = exponent < 0 ? '-' : '+';
  const int size = std::abs(exponent);
  if (size >= 100) *out++ = static_cast<char>('0' + size / 100);
  *out++ = static_cast<char>('0' + size / 10 % 10);
  *out++ = static_cast<char>('0' + size % 10);
  return out;
}

template <typename... Args>
char* WriteChars(char* out, Args... args) {
  return std::to_chars(out, out + kLongestNumber, args...).ptr;
}

// Writes `value` if 1e-3 <= |value| < 1e4 and a decimal of at most 15 digits is parsed as exactly
// `value`. Returns null for other values.
char* WriteShortDecimal(char* out, double value) {
  // Every decimal of at most 15 digits is unchanged by a conversion to double and back.
  constexpr int kCertain = 15;
  const double magnitude = std::abs(value);
  if (!(magnitude >= 1e-3 && magnitude < 1e4)) return nullptr;
  int exponent = -3;
  for (const double power : {1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3}) exponent += magnitude >= power;
  // The decimal is parsed as the double `whole` / `power`: both numbers are exact as doubles, so
  // their quotient is rounded only once, in the same way as a parsed decimal.
  const double power = kPowers[static_cast<size_t>(kCertain - 1 - exponent)];
  const double scaled = magnitude * power;
  auto whole = static_cast<std::uint64_t>(scaled);
  if (scaled - static_cast<double>(whole) >= 0.5) ++whole;
  if (static_cast<double>(whole) / power != magnitude) return nullptr;
  if (value < 0) *out++ = '-';
  return WritePositional(out, Digits(whole * 10), exponent);
}

// Writes a whole number from 0 to 9, the most frequent case. Returns null for other values.
char* WriteDigit(char* out, double value) {
  if (!(value >= 0 && value <= 9)) return nullptr;
  const int digit = static_cast<int>(value);
  if (digit != value) return nullptr;
  *out = static_cast<char>('0' + digit);
  return out + 1;
}

template <auto write>
void Append(std::string& out, double value) {
  std::array<char, kLongestNumber> text;
  out.append(text.data(), write(text.data(), value));
}

std::optional<double> ParseInteger(std::string_view digits, int base) {
  std::uint64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value, base);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return static_cast<double>(value);
}

}  // namespace

// Writes the same text as printf("%.10g") in the C locale, except "0" for -0: without an exponent
// if 1e-4 <= |value| < 1e10, otherwise with an exponent of at least two digits. std::to_chars,
// which is slower, is used only if the rounding is uncertain.
char* WriteNumber(char* out, double value) {
  const double magnitude = std::abs(value);
  if (char* const end = WriteDigit(out, value)) return end;
  if (magnitude < kPowers[kDigits]) {
    const auto whole = static_cast<std::int64_t>(value);
    if (static_cast<double>(whole) == value) return WriteChars(out, whole);
  }
  const std::optional<Decimal> decimal = Rounded(magnitude);
  if (!decimal) return WriteChars(out, value, std::chars_format::general, kDigits);
  const Digits digits(decimal->digits * 1'000'000);
  if (value < 0) *out++ = '-';
  const bool positional = decimal->exponent >= -4 && decimal->exponent < kDigits;
  return positional ? WritePositional(out, digits, decimal->exponent)
                    : WriteScientific(out, digits, decimal->exponent);
}

void AppendNumber(std::string& out, double value) { Append<WriteNumber>(out, value); }

std::string NumberText(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

// Writes the shortest text that is parsed as exactly `value`. Most drawn values have few digits, so
// WriteShortDecimal() is tried first. No two decimals of at most 15 digits are parsed as the same
// double, so a decimal that it finds is the shortest.
char* WriteExactNumber(char* out, double value) {
  const bool minus_zero = value == 0 && std::signbit(value);
  char* end = minus_zero ? nullptr : WriteDigit(out, value);
  if (end == nullptr) end = WriteShortDecimal(out, value);
  return end == nullptr ? WriteChars(out, value) : end;
}

void AppendExactNumber(std::string& out, double value) { Append<WriteExactNumber>(out, value); }

std::string ExactNumberText(double value) {
  std::string text;
  AppendExactNumber(text, value);
  return text;
}

// Rejects numbers outside the range of a double (1e999), including 1e-999, which would become 0.
std::optional<double> ParseNumber(std::string_view text) {
  if (text.starts_with("0x")) return ParseInteger(text.substr(2), 16);
  if (text.starts_with("0o")) return ParseInteger(text.substr(2), 8);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  // Rejects "inf", "nan" and a second sign, which std::from_chars would accept.
  if (text.empty() || (!IsDigit(text.front()) && text.front() != '.')) return std::nullopt;
  double value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return negative ? -value : value;
}

}  // namespace mjforge::expr
