#include "fuzz/variants.h"

#include "mjforge/xml/xml.h"

namespace mjforge::fuzz {
namespace {

constexpr std::uint64_t kVariants = 3;
// Of larger objects one is made, and of those that are drawn a hundred times in vain: more would
// only take longer.
constexpr std::size_t kLarge = 1 << 16;

std::string LineOf(const manifest::Record& record) {
  std::string line;
  manifest::AppendRecord(line, record);
  return line;
}

void CheckFile(const forge::Variant& variant) {
  const std::string& text = variant.document.text;
  const auto fault = xml::FindMjcfFault(text);
  Must(!fault, fault ? "the file is no MJCF: " + fault->message : "");
  const std::optional<mjcf::Provenance> provenance = mjcf::ReadProvenance(text);
  Must(provenance.has_value(), "the file does not say how it was made");
  Must(provenance->index == variant.record.index && provenance->seed == variant.record.seed,
       "the file says that it is another variant");
}

void CheckRecord(const manifest::Record& record) {
  const std::string line = LineOf(record);
  std::string why_not;
  const auto read =
      manifest::ReadRecord(std::string_view(line).substr(0, line.size() - 1), why_not);
  Must(read.has_value(), "a record cannot be read back: " + why_not);
  Must(LineOf(*read) == line, "a record was read back as another one:\n" + line + LineOf(*read));
}

}  // namespace

void MakeVariants(const forge::Recipe& recipe, diag::Sources& sources, forge::Options options) {
  options.validation = forge::Validation::kNone;
  forge::Generator generator(recipe, sources, options);
  forge::Variant variant;
  for (std::uint64_t index = 0; index < kVariants; ++index) {
    generator.Make(index, variant);
    Word(variant.findings, sources);
    CheckRecord(variant.record);
    if (variant.ok()) CheckFile(variant);
    const bool is_hopeless = options.on_invalid == forge::OnInvalid::kResample && !variant.ok();
    if (is_hopeless || variant.document.text.size() > kLarge) return;
    forge::Variant alone;
    forge::Generator(recipe, sources, options).Make(index, alone);
    Must(LineOf(alone.record) == LineOf(variant.record), "a variant alone has another record");
    Must(!variant.ok() || alone.document.text == variant.document.text,
         "a variant alone has another file");
  }
}

}  // namespace mjforge::fuzz
