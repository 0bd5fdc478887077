// The part of Evaluator that draws: numbers, options, rotations, points, colours.

#include <cmath>
#include <limits>
#include <numbers>

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

// Counted or logical values are whole as they are.
bool IsRounded(Distribution distribution) {
  return distribution != Distribution::kInteger && distribution != Distribution::kPoisson &&
         distribution != Distribution::kBernoulli;
}

bool HasNan(std::span<const double> numbers) {
  for (const double number : numbers) {
    if (std::isnan(number)) return true;
  }
  return false;
}

}  // namespace

double Evaluator::DrawNumber(const spec::Draw& draw, SourceMark mark, StreamId path) {
  Numbers arguments;
  for (std::size_t i = 0; i < draw.arguments.size(); ++i) {
    arguments.push_back(Number(draw.arguments[i], ItemStream(draw.arguments[i], path, i)));
  }
  std::optional<Interval> limits;
  if (draw.limits.size() == 2) {
    const StreamId limits_path = Child(path, Info(draw.distribution).option);
    limits = Interval{Number(draw.limits[0], Child(limits_path, std::size_t{0})),
                      Number(draw.limits[1], Child(limits_path, std::size_t{1}))};
    if (std::isnan(limits->lo) || std::isnan(limits->hi)) return limits->lo + limits->hi;
  }
  const std::span<const double> numbers(arguments.data(), arguments.size());
  if (HasNan(numbers)) return std::numeric_limits<double>::quiet_NaN();
  return DrawFrom(draw.distribution, numbers, limits, mark, path);
}

double Evaluator::DrawFrom(Distribution distribution, std::span<const double> arguments,
                           std::optional<Interval> limits, SourceMark mark, StreamId path) {
  if (auto wrong = CheckArguments(distribution, arguments, limits)) {
    const auto stated = StatedInterval(distribution, arguments, limits);
    const bool empty = stated && stated->lo > stated->hi;
    return Fail(
        empty ? Code::kSampleEmptyRange : Code::kSampleBadArgument, mark, std::move(*wrong),
        empty ? "write the lower end first, or keep the ends apart with min() and max()" : "");
  }
  const double u = Uniforms(path)[0];
  const double value = Quantile(distribution, arguments, limits, u);
  if (!std::isfinite(value)) {
    return Fail(Code::kSampleBadArgument, mark,
                fmt::format("'{}' drew a value that is not finite", Info(distribution).key));
  }
  if (!IsRounded(distribution)) return value;
  const Interval support = Support(distribution, arguments, limits);
  return RoundDraw(value, support.lo, support.hi);
}

const spec::Value& Evaluator::Chosen(const spec::Draw& draw, SourceMark mark, StreamId& path) {
  const std::size_t count = draw.arguments.size();
  std::size_t option;
  if (draw.distribution == Distribution::kCycle) {
    option = static_cast<std::size_t>(key_.index % count);
  } else if (!draw.weights.empty() || IsExact(draw)) {
    option = WeightedOption(draw, mark, path);
  } else {
    option = static_cast<std::size_t>(Uniforms(path)[0] * static_cast<double>(count));
  }
  path = Child(Child(path, Info(draw.distribution).key), option);
  return draw.arguments[option];
}

std::size_t Evaluator::WeightedOption(const spec::Draw& draw, SourceMark mark, StreamId path) {
  Numbers weights;
  const StreamId weights_path = Child(path, "weights");
  double sum = 0;
  for (std::size_t i = 0; i < draw.weights.size(); ++i) {
    const double weight = Number(draw.weights[i], ItemStream(draw.weights[i], weights_path, i));
    if (weight < 0) {
      Fail(Code::kSampleBadArgument, draw.weights[i].mark,
           fmt::format("weight {} of the choice is {}; it must not be negative", i + 1,
                       NumberText(weight)));
      return 0;
    }
    weights.push_back(weight);
    sum += weight;
  }
  if (draw.weights.empty()) {  // of an exact choice
    weights.assign(draw.arguments.size(), 1);
    sum = 1;
  }
  if (std::isnan(sum)) return 0;
  if (sum <= 0 || std::isinf(sum)) {
    Fail(Code::kSampleBadArgument, mark,
         sum <= 0 ? "all weights of the choice are 0; one must be positive"
                  : "the sum of the choice's weights is infinite");
    return 0;
  }
  if (IsExact(draw)) {
    return sampler_->ExactOption({weights.data(), weights.size()}, key_, path);
  }
  return WeightedIndex({weights.data(), weights.size()}, Uniforms(path)[0]);
}

void Evaluator::AppendAbout(const spec::RotationAbout& about, SourceMark mark, StreamId path,
                            Numbers& out) {
  Numbers axis;
  Vector(*about.axis, Child(path, "about"), axis);
  double length = 0;
  for (const double component : axis) length = std::hypot(length, component);
  if (length == 0) {
    Fail(Code::kSampleBadArgument, mark, "the axis to turn about is 0 0 0; it needs a direction");
  }
  // From -pi/2 to pi/2, so that w is not negative.
  const double half_angle = std::numbers::pi * (Uniforms(path)[0] - 0.5);
  out.push_back(std::cos(half_angle));
  for (const double component : axis) out.push_back(std::sin(half_angle) * (component / length));
}

void Evaluator::AppendOnSphere(const spec::PointOnSphere& point, SourceMark mark, StreamId path,
                               Numbers& out) {
  const double radius = Number(*point.radius, Child(path, "on_sphere"));
  if (radius < 0) {
    Fail(
        Code::kSampleBadArgument, mark,
        fmt::format("the radius of the sphere is {}; it must not be negative", NumberText(radius)));
  }
  const std::array<double, 4> u = Uniforms(path);
  for (const double component : UniformDirection(u[0], u[1])) out.push_back(radius * component);
}

void Evaluator::AppendColor(const spec::HsvColor& color, SourceMark mark, StreamId path,
                            Numbers& out) {
  static constexpr std::array<std::string_view, 4> kNames = {"hue", "saturation", "value", "alpha"};
  std::array<double, 4> items = {0, 0, 0, 1};  // opaque unless said
  for (std::size_t i = 0; i < color.items.size(); ++i) {
    items[i] = Number(color.items[i], ItemStream(color.items[i], path, i));
    if (items[i] < 0 || items[i] > 1) {
      Fail(Code::kSampleBadArgument, color.items[i].mark ? color.items[i].mark : mark,
           fmt::format("{} is {}; it must be between 0 and 1", kNames[i], NumberText(items[i])));
    }
    if (!(items[i] >= 0 && items[i] <= 1)) items[i] = 0;
  }
  for (const double channel : HsvToRgb(items[0], items[1], items[2])) out.push_back(channel);
  out.push_back(items[3]);
}

}  // namespace mjforge::sample
