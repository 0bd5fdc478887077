// Rows of families (.npz files): the numbers of each variant's compiled model and of its record.

#include "mjforge/batch/family_rows.h"

#include <fmt/format.h>

#include <algorithm>
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

bool FamilyRows::Add(const forge::Variant& variant, const std::string& file,
                     diag::Findings& findings) {
  const manifest::Record& record = variant.record;
  family::Numbers numbers = *variant.numbers;
  AddRecord(record, numbers);
  auto family = std::ranges::find(families_, file, &Family::file);
  if (family == families_.end()) {
    family =
        families_.insert(family, {.file = file, .rows = {}, .first = record.index, .base = {}});
    family->base = family::BaseOf(variant.document, numbers, record.mocap);
  }
  const std::string difference = family->rows.Add(numbers, record.params);
  if (difference.empty()) return true;
  findings.Add(diag::Code::kBatchDiffers, {},
               fmt::format("variant {} has another structure than variant {}: {}", record.index,
                           family->first, difference),
               "set the parameter that decides it with --set, or write to a folder");
  return false;
}

std::string FamilyRows::Take() {
  std::string bytes;
  for (const Family& family : std::exchange(families_, {}))
    bytes += family.rows.Header(family.base) + family.rows.Bytes();
  return bytes;
}

}  // namespace mjforge::batch
