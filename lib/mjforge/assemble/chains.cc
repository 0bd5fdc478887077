// Reads `chain:` of a body, and makes the ball joints or pairs of hinges between links.

#include "mjforge/assemble/chains.h"

#include <initializer_list>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

using spec::Key;
namespace {

// Impedance (solimplimit) of the joints' limits, in place of MuJoCo's default "0.9 0.95 ...".
// MuJoCo chooses the softness of a limit by the inertia of one link, but the limit also carries all
// links below.
constexpr std::initializer_list<double> kLimitImpedance = {0.99, 0.999, 0.001, 0.5, 2};

}  // namespace

std::optional<Chain> ReadChain(const FieldReader& body, const spec::Entry& entry) {
  FieldReader reader = body.ForChild(entry.element->name, 0);
  const std::optional<double> links = reader.Number(*entry.Find(Key::kLinks));
  const std::optional<double> length = reader.Number(*entry.Find(Key::kLength));
  std::string joint = "ball";
  const bool good = reader.ReadOptional(entry, Key::kJoint, &FieldReader::Word, joint);
  if (!links || !length || !good) return std::nullopt;
  Chain chain = {
      .links = static_cast<int>(*links), .pitch = *length / *links, .is_ball = joint == "ball"};
  if (const spec::Field* range = entry.Find(Key::kRange)) {
    chain.range = reader.Number(*range);
    if (!chain.range) return std::nullopt;
    if (chain.is_ball && *chain.range > std::numbers::pi) {
      reader.Report(diag::Code::kModelBadValue, *range,
                    fmt::format("is {} deg; a ball joint turns by at most 180 deg",
                                expr::RoundedText(*chain.range * 180 / std::numbers::pi)));
      return std::nullopt;
    }
  }
  if (!ReadAttributes(reader, entry, chain.attributes)) return std::nullopt;
  return chain;
}

std::vector<model::Joint> JointsOfLink(const Chain& chain, const std::string& link,
                                       diag::SourceMark mark) {
  model::Joint joint;
  joint.name = link;
  joint.type = chain.is_ball ? "ball" : "hinge";
  joint.mark = mark;
  joint.attributes = chain.attributes;
  if (chain.range) {
    joint.range = Eigen::Vector2d(chain.is_ball ? 0 : -*chain.range, *chain.range);
    joint.attributes.push_back({.name = "solimplimit", .numbers = kLimitImpedance});
  }
  if (chain.is_ball) return {joint};
  std::vector<model::Joint> hinges(2, joint);
  hinges[0].name += "_x";
  hinges[0].axis = Eigen::Vector3d::UnitX();
  hinges[1].name += "_y";
  hinges[1].axis = Eigen::Vector3d::UnitY();
  return hinges;
}

}  // namespace mjforge::assemble
