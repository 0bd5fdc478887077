// Variants of a small family, as Read() describes them.

#include "sample_rows.h"

#include "mjforge/structure/structure.h"

namespace mjforge::family::sample_rows {
namespace {

void AddElements(Numbers& numbers, std::string name, std::string element,
                 std::vector<double> values, ArrayShape::Type type = ArrayShape::Type::kNumber) {
  ArrayShape& shape = numbers.shapes.emplace_back();
  shape.name = std::move(name);
  shape.type = type;
  if (!element.empty()) shape.elements = {std::move(element)};
  shape.dims = {shape.elements.size()};
  if (values.size() > 1) shape.dims.push_back(values.size());
  if (!shape.elements.empty())
    numbers.values.insert(numbers.values.end(), values.begin(), values.end());
}

}  // namespace

Numbers Ball(double radius, const std::string& material, double red, double shift) {
  using Type = ArrayShape::Type;
  Numbers numbers;
  AddElements(numbers, "body_mass", "ball", {radius});
  AddElements(numbers, "body_inertia", "ball", {1, 1, 1});
  AddElements(numbers, "body_ipos", "ball", {0, 0, shift});
  AddElements(numbers, "body_iquat", "ball", {1, 0, 0, 0});
  AddElements(numbers, "geom_size", "core", {radius, 0, 0});
  AddElements(numbers, "geom_pos", "core", {0, 0, shift});
  AddElements(numbers, "geom_quat", "core", {1, 0, 0, 0});
  AddElements(numbers, "geom_matid", "core", {0}, Type::kMaterial);
  AddElements(numbers, "site_pos", "", {});
  AddElements(numbers, "site_quat", "", {});
  AddElements(numbers, "jnt_pos", "", {});
  AddElements(numbers, "dof_frictionloss", "", {});
  const double frame = shift == 0 ? structure::kBody : structure::kBodyRotation;
  AddElements(numbers, "body_sameframe", "ball", {frame}, Type::kFlag);
  AddElements(numbers, "geom_sameframe", "core", {frame}, Type::kFlag);
  AddElements(numbers, "site_sameframe", "", {}, Type::kFlag);
  AddElements(numbers, "jnt_simple", "", {}, Type::kFlag);
  Material look;
  look.name = material;
  look.elements = "    <material name=\"" + material + "\"/>\n";
  look.numbers[0] = red;
  numbers.materials = {look};
  return numbers;
}

const char* const kBase =
    "<mujoco model=\"ball\">\n"
    "  <asset>\n"
    "    <material name=\"oak\"/>\n"
    "  </asset>\n"
    "  <worldbody>\n"
    "    <body name=\"ball\" pos=\"0 0 0\">\n"
    "      <inertial pos=\"0 0 0\" quat=\"1 0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>\n"
    "      <geom name=\"core\" type=\"sphere\" size=\"1\" pos=\"0 0 0\"/>\n"
    "    </body>\n"
    "  </worldbody>\n"
    "</mujoco>\n";

}  // namespace mjforge::family::sample_rows
