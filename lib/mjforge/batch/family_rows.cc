// Rows of a family: numbers of the model and of the record.

#include "mjforge/batch/family_rows.h"

#include <fmt/format.h>

#include <bit>
#include <utility>

namespace mjforge::batch {
namespace {

void AddRecord(const manifest::Record& record, family::Numbers& numbers) {
  const auto& bounds = record.bounds;
  const auto add = [&](std::string name, double number) {
    numbers.Add(std::move(name), {}, {&number, 1});
  };
  const double index = std::bit_cast<double>(record.index);
  numbers.Add("index", {}, {&index, 1}, family::ArrayShape::Type::kIndex);
  add("mass", record.mass_properties.mass);
  const auto& lo = bounds.aabb.min;
  const auto& hi = bounds.aabb.max;
  const double box[] = {lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]};
  numbers.Add("bounds", {2, 3}, box);
  add("top_offset", bounds.top_offset);
  add("bottom_offset", bounds.bottom_offset);
  add("horizontal_radius", bounds.horizontal_radius);
}

}  // namespace

bool FamilyRows::Add(const forge::Variant& variant, diag::Findings& findings) {
  family::Numbers numbers = *variant.numbers;
  AddRecord(variant.record, numbers);
  if (rows_.empty()) {
    first_ = variant.record.index;
    base_ = family::BaseOf(variant.document, numbers, variant.record.mocap);
  }
  const std::string difference = rows_.Add(numbers, variant.record.params);
  if (difference.empty()) return true;
  ReportOtherStructure(variant.record.index, first_, difference, findings);
  return false;
}

std::pair<std::string, std::string> FamilyRows::Take() {
  std::pair<std::string, std::string> bytes(rows_.Header(base_), rows_.Bytes());
  rows_.Clear();
  return bytes;
}

void ReportOtherStructure(std::uint64_t index, std::uint64_t other, const std::string& difference,
                          diag::Findings& findings) {
  findings.Add(
      diag::Code::kBatchDiffers, {},
      fmt::format("variant {} has another structure than variant {}: {}", index, other, difference),
      "set the parameter that decides it with --set, or write to a folder");
}

}  // namespace mjforge::batch
