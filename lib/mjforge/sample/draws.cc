// Functions of Evaluator that draw numbers, options, rotations, points on a sphere and colours.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "mjforge/sample/distributions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using diag::Code;
using diag::SourceMark;
using expr::NumberText;
using spec::Distribution;

const spec::DistributionInfo& Info(Distribution distribution) {
  return spec::Distributions()[static_cast<std::size_t>(distribution)];
}

// Returns true for distributions whose draws RoundWithin() rounds: all except distributions of
// integers and booleans.
bool IsRounded(Distribution distribution) {
  return distribution != Distribution::kInteger && distribution != Distribution::kPoisson &&
         distribution != Distribution::kBernoulli;
}

// Upper limit for the number of arguments and limits of a draw: at most three arguments (triangular
// distribution) and two limits.
constexpr std::size_t kMostArguments = 5;

template <std::size_t n>
void Append(const std::array<double, n>& numbers, Numbers& out) {
  out.insert(out.end(), numbers.begin(), numbers.end());
}

}  // namespace

double Evaluator::DrawNumber(const spec::Draw& draw, SourceMark mark, StreamId path) {
  const std::size_t count = draw.arguments.size();
  std::array<double, kMostArguments> memory;
  const std::span all(memory.data(), count + draw.limits.size());
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = Number(draw.arguments[i], ItemStream(draw.arguments[i], path, i));
  }
  const StreamId limits_path =
      draw.limits.empty() ? path : Child(path, Info(draw.distribution).option);
  for (std::size_t i = 0; i < draw.limits.size(); ++i) {
    all[count + i] = Number(draw.limits[i], Child(limits_path, i));
  }
  if (HasFailedNumber(all)) return kFailedNumber;
  const std::span<const double> arguments = all.first(count);
  std::optional<Interval> limits;
  if (!draw.limits.empty()) limits = {all[count], all[count + 1]};
  if (auto wrong = CheckArguments(draw.distribution, arguments, limits)) {
    const auto stated = StatedInterval(draw.distribution, arguments, limits);
    const bool empty = stated && stated->lo > stated->hi;
    return Fail(
        empty ? Code::kSampleEmptyRange : Code::kSampleBadArgument, mark, std::move(*wrong),
        empty ? "write the lower end first, or keep the ends apart with min() and max()" : "");
  }
  double value = Quantile(draw.distribution, arguments, limits, Uniforms(path)[0]);
  if (IsRounded(draw.distribution)) {
    const Interval support = Support(draw.distribution, arguments, limits);
    value = RoundWithin(support.lo, support.hi, value);
  }
  if (std::isfinite(value)) return value;
  return Fail(Code::kSampleBadArgument, mark,
              fmt::format("'{}' drew a value that is not finite", Info(draw.distribution).key));
}

const spec::Draw* Evaluator::ChoiceOf(const spec::Value& value) {
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  return draw != nullptr && draw->is_choice() ? draw : nullptr;
}

const spec::Value* Evaluator::ChooseRow(const spec::Draw& draw, SourceMark mark, StreamId& path) {
  const spec::RecordRows& rows = *draw.rows;
  const double key = Variable(draw.key_slot);
  const auto row = std::isnan(key) ? rows.numbers.end() : rows.numbers.find(key);
  if (row == rows.numbers.end()) {
    // All columns of a record use the same key, so a missing row is reported only for the first
    // column.
    if (!failed_) Fail(Code::kSampleBadArgument, mark, "no row has the key of this record");
    return nullptr;
  }
  path = Child(path, rows.names[row->second]);
  return &draw.arguments[row->second];
}

const spec::Value* Evaluator::Choose(const spec::Draw& draw, SourceMark mark, StreamId& path) {
  if (draw.rows != nullptr) return ChooseRow(draw, mark, path);
  const std::optional<std::size_t> option = DrawOption(draw, mark, path);
  if (!option) return nullptr;
  path = Child(Child(path, Info(draw.distribution).key), *option);
  return &draw.arguments[*option];
}

std::optional<std::size_t> Evaluator::DrawOption(const spec::Draw& draw, SourceMark mark,
                                                 StreamId path) {
  const std::size_t count = draw.arguments.size();
  if (draw.distribution == Distribution::kCycle) {
    return static_cast<std::size_t>(key_.index % count);
  }
  std::optional<Numbers> weights = Weights(draw, mark, path);
  if (!weights) return std::nullopt;
  if (draw.exact && sampler_ != nullptr && sampler_->batch() > 0) {
    if (weights->empty()) weights->assign(count, 1);
    return sampler_->ExactOption({weights->data(), weights->size()}, key_, path);
  }
  const double u = Uniforms(path)[0];
  if (weights->empty()) return static_cast<std::size_t>(u * static_cast<double>(count));
  return WeightedIndex({weights->data(), weights->size()}, u);
}

std::optional<Numbers> Evaluator::Weights(const spec::Draw& draw, SourceMark mark, StreamId path) {
  Numbers weights;
  if (draw.weights.empty()) return weights;
  const StreamId weights_path = Child(path, "weights");
  for (std::size_t i = 0; i < draw.weights.size(); ++i) {
    const double weight = Number(draw.weights[i], ItemStream(draw.weights[i], weights_path, i));
    weights.push_back(weight);
    if (!(weight < 0)) continue;
    Fail(Code::kSampleBadArgument, draw.weights[i].mark,
         fmt::format("weight {} of the choice is {}; it must not be negative", i + 1,
                     NumberText(weight)));
    return std::nullopt;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (sum > 0 && std::isfinite(sum)) return weights;
  if (!std::isnan(sum)) {
    Fail(Code::kSampleBadArgument, mark,
         sum > 0 ? "the sum of the choice's weights is infinite"
                 : "all weights of the choice are 0; one must be positive");
  }
  return std::nullopt;
}

void Evaluator::AppendRotation(StreamId path, Numbers& out) {
  const std::array<double, 4> u = Uniforms(path);
  Append(UniformRotation(u[0], u[1], u[2]), out);
}

void Evaluator::AppendRotationAbout(const spec::RotationAbout& about, SourceMark mark,
                                    StreamId path, Numbers& out) {
  Numbers axis;
  Vector(*about.axis, Child(path, "about"), axis);
  // The result of std::hypot with three arguments is the same to the last bit on every processor.
  // With two arguments, the last bit can differ.
  double length = std::hypot(axis[0], axis[1], axis[2]);
  if (length == 0) {
    length = Fail(Code::kSampleBadArgument, mark,
                  "the axis to turn about is 0 0 0; it needs a direction");
  }
  // The half angle is between -pi/2 and pi/2, so that w is not negative.
  const double half_angle = std::numbers::pi * (Uniforms(path)[0] - 0.5);
  out.push_back(std::cos(half_angle));
  for (const double component : axis) out.push_back(std::sin(half_angle) * (component / length));
}

void Evaluator::AppendPointOnSphere(const spec::PointOnSphere& point, SourceMark mark,
                                    StreamId path, Numbers& out) {
  double radius = Number(*point.radius, Child(path, "on_sphere"));
  if (radius < 0) {
    radius = Fail(
        Code::kSampleBadArgument, mark,
        fmt::format("the radius of the sphere is {}; it must not be negative", NumberText(radius)));
  }
  const std::array<double, 4> u = Uniforms(path);
  for (const double component : UniformDirection(u[0], u[1])) out.push_back(component * radius);
}

void Evaluator::AppendColor(const spec::HsvColor& color, SourceMark mark, StreamId path,
                            Numbers& out) {
  static constexpr std::array<std::string_view, 4> kNames = {"hue", "saturation", "value", "alpha"};
  std::array<double, 4> items = {0, 0, 0, 1};  // opaque by default
  for (std::size_t i = 0; i < color.items.size(); ++i) {
    items[i] = Number(color.items[i], ItemStream(color.items[i], path, i));
    if (!(items[i] < 0 || items[i] > 1)) continue;
    items[i] =
        Fail(Code::kSampleBadArgument, color.items[i].mark ? color.items[i].mark : mark,
             fmt::format("{} is {}; it must be between 0 and 1", kNames[i], NumberText(items[i])));
  }
  if (HasFailedNumber(items)) {
    out.insert(out.end(), items.size(), kFailedNumber);
    return;
  }
  Append(HsvToRgb(items[0], items[1], items[2]), out);
  out.push_back(items[3]);
}

}  // namespace mjforge::sample
