// Survey of a family by reading all of its variants once.

#include "mjforge/family/survey.h"

#include <algorithm>
#include <stdexcept>

namespace mjforge::family {
namespace {

// Returns the <texture> line of a material, without the <material> line.
std::string TextureOf(const Material& material) {
  return material.elements.substr(0, material.elements.find("<material "));
}

class Surveyor {
 public:
  explicit Surveyor(const Header& header) : shapes_(header.shapes) {
    for (const std::string& name : header.parameters)
      survey_.parameters.push_back({.name = name, .first = {}});
  }

  void Add(const RowView& row) {
    AddMaterials(row);
    AddNumbers(row);
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
      AddParameter(row.parameters[i], survey_.parameters[i]);
    ++survey_.count;
  }

  Survey Take() { return std::move(survey_); }

 private:
  void AddNumbers(const RowView& row) {
    const bool is_first = survey_.count == 0;
    if (is_first) {
      survey_.first.assign(row.values.begin(), row.values.end());
      survey_.largest = survey_.first;
      survey_.varies.resize(row.values.size());
      survey_.flags.resize(row.values.size());
    }
    std::size_t at = 0;
    for (const ArrayShape& shape : shapes_) {
      for (const std::size_t end = at + shape.size(); at < end; ++at) {
        double value = row.values[at];
        if (shape.type == ArrayShape::Type::kMaterial) value = survey_.MaterialId(row, value);
        if (is_first) survey_.first[at] = value;
        if (shape.type == ArrayShape::Type::kFlag) survey_.flags[at] |= 1U << unsigned(value);
        survey_.varies[at] = survey_.varies[at] || value != survey_.first[at];
        survey_.largest[at] = std::max(survey_.largest[at], value);
      }
    }
  }

  void AddMaterials(const RowView& row) {
    for (std::size_t i = 0; i < row.materials.size(); ++i) {
      const Material& material = *row.materials[i];
      auto known = std::ranges::find(survey_.materials, material.name, &Material::name);
      if (known == survey_.materials.end()) {
        known = survey_.materials.insert(known, material);
        known->numbers = row.material_numbers[i];
        survey_.material_varies.emplace_back();
      } else if (TextureOf(*known) != TextureOf(material)) {
        survey_.other_textures.insert(material.name);
      }
      auto& varies =
          survey_.material_varies[static_cast<std::size_t>(known - survey_.materials.begin())];
      for (std::size_t j = 0; j < varies.size(); ++j)
        varies[j] = varies[j] || row.material_numbers[i][j] != known->numbers[j];
    }
  }

  void AddParameter(const sample::ParameterValue& value, Survey::Parameter& parameter) {
    if (survey_.count == 0) {
      parameter.kind = value.index();
      parameter.first = value;
    }
    parameter.varies = parameter.varies || value != parameter.first;
    const auto add_text = [&](const std::string& text) {
      parameter.code_points =
          std::max<std::uint64_t>(parameter.code_points, output::CodePoints(text));
    };
    std::visit(
        [&](const auto& held) {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<Held, std::string>) add_text(held);
          if constexpr (requires { held.begin(); } && !std::is_same_v<Held, std::string>)
            parameter.length = std::max<std::uint64_t>(parameter.length, held.size());
          if constexpr (std::is_same_v<Held, std::vector<std::string>>)
            std::ranges::for_each(held, add_text);
        },
        value);
  }

  const std::vector<ArrayShape>& shapes_;
  Survey survey_;
};

}  // namespace

double Survey::MaterialId(const RowView& row, double id) const {
  if (id < 0) return id;
  if (id >= static_cast<double>(row.materials.size())) throw std::runtime_error("it is damaged");
  const std::string& name = row.materials[static_cast<std::size_t>(id)]->name;
  const auto known = std::ranges::find(materials, name, &Material::name);
  return static_cast<double>(known - materials.begin());
}

Survey SurveyOf(std::span<RowsFile> files) {
  const auto filled = std::ranges::find_if(files, [](const RowsFile& f) { return f.count() > 0; });
  if (filled == files.end()) return {};
  Surveyor surveyor(filled->header());
  for (RowsFile& file : files) file.ForEach([&](const RowView& row) { surveyor.Add(row); });
  return surveyor.Take();
}

}  // namespace mjforge::family
