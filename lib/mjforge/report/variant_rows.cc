// Rows of the table of variants in a report, with picture, parameters, findings and the command
// that regenerates the variant.

#include "mjforge/report/variant_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

#include "mjforge/expr/expr.h"
#include "mjforge/output/output.h"
#include "mjforge/report/axis.h"
#include "mjforge/report/color_parameters.h"

namespace mjforge::report {
namespace {

using manifest::Record;
using Params = std::vector<std::pair<std::string, sample::ParameterValue>>;

constexpr std::size_t kOpenParams = 6;    // number of parameters shown without a click
constexpr std::size_t kMaxParams = 40;    // number of parameters of a variant in the page
constexpr std::size_t kNamedParams = 3;   // number of parameters in a picture's alt text
constexpr std::size_t kMaxFindings = 4;   // number of findings shown for a variant
constexpr std::size_t kValueBytes = 120;  // largest length of the text of a value

std::string ValueText(const sample::ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
  if (const auto text = TextOfWords(value)) return Clean(*text, kValueBytes);
  return Clean(fmt::format("{:.6g}", fmt::join(std::get<std::vector<double>>(value), " ")),
               kValueBytes);
}

bool Varies(const ParameterTally& tally) {
  const auto values = tally.Values();
  if (!values.empty()) return values.size() > 1;
  return std::any_of(tally.numbers.begin(), tally.numbers.end(), [](const NumberTally& numbers) {
    return numbers.all.min() != numbers.all.max();
  });
}

// Fills in the text of a measure ("0.123 kg"), and the number by which the page's script sorts
// rows.
void SetMeasure(Dictionary& row, const char* text, const char* number, std::optional<double> value,
                std::string_view unit) {
  Set(row, text, value ? fmt::format("{} {}", ShortNumber(*value), unit) : "none");
  Set(row, number, value ? expr::NumberText(*value) : "");
}

class RowMaker {
 public:
  RowMaker(const Batch& batch, const Request& request, const Thumbnailer& thumbnailer)
      : batch_(batch), request_(request), thumbnailer_(thumbnailer) {
    for (const ParameterTally& tally : batch.summary.params.list()) {
      if (Varies(tally)) varied_.insert(tally.name);
    }
    if (batch.recipe) colors_ = ColorsOf(*batch.recipe->spec);
  }

  // Returns the HTML of a row. Sets `has_picture` to false if the variant has a file but no
  // picture.
  std::string Make(const ShownVariant& shown, bool& has_picture) const {
    const Record& record = shown.record;
    ctemplate::TemplateDictionary row("row");
    Set(row, "INDEX", fmt::format("{}", record.index));
    Set(row, "STATUS", NameOf(record.status));
    if (shown.reason == ShownVariant::Reason::kSlow) Section(row, "SLOW");
    const auto measured = [&](MeasureId id) { return MeasureOf(id).of(record); };
    SetMeasure(row, "MASS", "MASS_NUMBER", measured(MeasureId::kMass), "kg");
    SetMeasure(row, "SIZE", "SIZE_NUMBER", measured(MeasureId::kSize), "m");
    const std::optional<double> rest = measured(MeasureId::kTimeToRest);
    SetMeasure(row, "IGNORED", "REST_NUMBER", rest, "s");
    if (batch_.summary.HasPhysics())
      ShowText(row, "REST", rest ? fmt::format("{} s", ShortNumber(*rest)) : "not at rest");
    Set(row, "REPLAY", ReplayCommand(request_, record.index));
    const Params params = Sorted(record.params);
    AddParams(row, params);
    AddFindings(row, record);
    has_picture = AddPicture(row, record, params);
    return Expand(TemplateName::kRow, row);
  }

 private:
  // Returns the parameters of a variant, first those whose values differ between variants.
  Params Sorted(Params params) const {
    std::stable_partition(params.begin(), params.end(),
                          [&](const auto& param) { return varied_.contains(param.first); });
    return params;
  }

  std::string UnitOf(const std::string& name) const {
    const std::string unit = UnitText(ParameterOf(batch_, name));
    return unit.empty() ? "" : " " + unit;
  }

  void AddParam(Dictionary& list, const Params::value_type& param) const {
    Dictionary& shown = Section(list, "PARAM");
    Set(shown, "NAME", Clean(param.first, kValueBytes));
    Set(shown, "VALUE", ValueText(param.second) + UnitOf(param.first));
    if (!colors_.contains(param.first)) return;
    ShowText(shown, "SWATCH", HexColor(param.second).value_or(""));
  }

  void AddParams(Dictionary& row, const Params& params) const {
    if (params.empty()) return;
    const std::size_t open = std::min(params.size(), kOpenParams);
    const std::size_t most = std::min(params.size(), kMaxParams);
    Dictionary& list = Section(row, "HAS_PARAMS");
    for (std::size_t i = 0; i < open; ++i) AddParam(list, params[i]);
    if (most > open) {
      Dictionary& more = Section(row, "MORE_PARAMS");
      Set(more, "TEXT", fmt::format("{} more", most - open));
      for (std::size_t i = open; i < most; ++i) AddParam(more, params[i]);
    }
    if (params.size() > most)
      ShowText(row, "LEFT_OUT", fmt::format("and {} in the manifest", params.size() - most));
  }

  static void AddFindings(Dictionary& row, const Record& record) {
    const std::vector<RecordedFinding> findings = FindingsOf(record);
    std::string codes;
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const RecordedFinding& finding = findings[i];
      if (i < 20) codes += (codes.empty() ? "" : " ") + Clean(finding.code, kValueBytes);
      if (i >= kMaxFindings) continue;
      Dictionary& shown = Section(row, "FINDING");
      Set(shown, "SEVERITY", finding.severity == "warning" ? "warning" : "error");
      Set(shown, "CODE", Clean(finding.code, kValueBytes));
      Set(shown, "MESSAGE", Clean(finding.message));
    }
    Set(row, "CODES", codes);
  }

  bool AddPicture(Dictionary& row, const Record& record, const Params& params) const {
    const std::optional<Thumbnail> thumbnail = thumbnailer_(record);
    if (!thumbnail) {
      ShowText(row, "NO_PICTURE",
               record.file.empty() ? "no picture: it has no file"
                                   : "no picture: its file cannot be shown");
      return record.file.empty();
    }
    std::string alt = fmt::format("Variant {}", record.index);
    for (std::size_t i = 0; i < std::min(params.size(), kNamedParams); ++i) {
      alt += fmt::format("{} {} {}{}", i == 0 ? ":" : ",", Clean(params[i].first, 40),
                         ValueText(params[i].second), UnitOf(params[i].first));
    }
    Dictionary& picture = Section(row, "PICTURE");
    SetPicture(picture, *thumbnail);
    Set(picture, "ALT", alt);
    return true;
  }

  const Batch& batch_;
  const Request& request_;
  const Thumbnailer& thumbnailer_;
  std::set<std::string> varied_;
  std::set<std::string> colors_;
};

// Returns the indices of the failed and slow variants in their order, then those of the sample in
// bit-reversed order, in which any first part is spread over the whole sample.
std::vector<std::size_t> OrderOfMaking(const std::vector<ShownVariant>& chosen) {
  const auto sample =
      std::ranges::find(chosen, ShownVariant::Reason::kSample, &ShownVariant::reason);
  const auto first = static_cast<std::size_t>(sample - chosen.begin());
  std::vector<std::size_t> order(first);
  std::iota(order.begin(), order.end(), 0);
  const int bits = std::countr_zero(std::bit_ceil(chosen.size() - first));
  for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
    std::size_t place = first;
    for (int bit = 0; bit < bits; ++bit) place += (i >> bit & 1) << (bits - 1 - bit);
    if (place < chosen.size()) order.push_back(place);
  }
  return order;
}

}  // namespace

std::string ReplayCommand(const Request& request, std::uint64_t index) {
  const std::string what = fmt::format("{}:{}", request.manifest.generic_string(), index);
  const std::string spec = request.spec.empty() ? "" : " --spec " + output::ShellWord(request.spec);
  return fmt::format("mjforge replay {}{}", output::ShellWord(what), spec);
}

VariantRows MakeVariantRows(const std::vector<ShownVariant>& chosen, const Batch& batch,
                            const Request& request, const Thumbnailer& thumbnailer,
                            std::size_t room) {
  const RowMaker maker(batch, request, thumbnailer);
  std::vector<std::string> rows(chosen.size());
  VariantRows made;
  std::size_t bytes = 0;
  for (const std::size_t place : OrderOfMaking(chosen)) {
    const ShownVariant& shown = chosen[place];
    bool has_picture = true;
    std::string row = maker.Make(shown, has_picture);
    if (bytes + row.size() > room) break;
    bytes += row.size();
    rows[place] = std::move(row);
    ++(shown.reason == ShownVariant::Reason::kFailed ? made.failed
       : shown.reason == ShownVariant::Reason::kSlow ? made.slow
                                                     : made.sampled);
    if (!has_picture) ++made.without_picture;
  }
  made.left_out = chosen.size() - made.shown();
  for (const std::string& row : rows) made.html += row;
  return made;
}

}  // namespace mjforge::report
