// The part of Evaluator that draws: numbers, options, rotations, points, colours.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "mjforge/sample/distributions.h"
#include "mjforge/sample/notes.h"

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

bool HasNan(std::span<const Traced<double>> numbers) {
  return std::ranges::any_of(numbers, [](double number) { return std::isnan(number); });
}

// The numbers that a draw takes. A triangular one has three, and limits are two.
constexpr std::size_t kMostArguments = 5;
class Arguments {
 public:
  // The first `count` are arguments, the others limits.
  template <typename List, typename Value>
  Arguments(const List& all, std::size_t count, Value value)
      : count_(count), has_limits_(all.size() > count) {
    std::ranges::transform(all, numbers_.begin(), value);
  }

  std::span<const double> numbers() const { return {numbers_.data(), count_}; }
  std::optional<Interval> limits() const {
    if (!has_limits_) return std::nullopt;
    return Interval{numbers_[count_], numbers_[count_ + 1]};
  }

 private:
  std::array<double, kMostArguments> numbers_;
  std::size_t count_;
  bool has_limits_;
};

// A draw whose arguments are known.
class Known {
 public:
  Known(Distribution distribution, const Arguments& arguments)
      : distribution_(distribution), arguments_(arguments) {
    if (!IsRounded(distribution)) return;
    const Interval support = Support(distribution, arguments.numbers(), arguments.limits());
    round_.emplace(support.lo, support.hi);
  }

  // Rounded as it is; not finite if the draw fails.
  double At(double u) const {
    const double value = Quantile(distribution_, arguments_.numbers(), arguments_.limits(), u);
    return round_ ? (*round_)(value) : value;
  }

 private:
  Distribution distribution_;
  Arguments arguments_;
  std::optional<Rounding> round_;
};

std::string_view WhatIsWrong(std::span<const double> weights) {
  if (weights.empty()) return {};
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(std::ranges::min(weights) >= 0)) return "a weight of the choice is negative";
  if (std::isinf(sum)) return "the sum of the choice's weights is infinite";
  return sum > 0 ? "" : "all weights of the choice are 0; one must be positive";
}

template <std::size_t n>
void Append(const Traced<std::array<double, n>>& numbers, Numbers& out) {
  for (std::size_t i = 0; i < n; ++i) out.push_back(Element(numbers, i));
}

}  // namespace

Traced<double> Evaluator::DrawNumber(const spec::Draw& draw, SourceMark mark, StreamId path) {
  const std::size_t count = draw.arguments.size();
  std::array<Traced<double>, kMostArguments> memory;
  const std::span all(memory.data(), count + draw.limits.size());
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = Number(draw.arguments[i], ItemStream(draw.arguments[i], path, i));
  }
  const StreamId limits_path =
      draw.limits.empty() ? path : Child(path, Info(draw.distribution).option);
  for (std::size_t i = 0; i < draw.limits.size(); ++i) {
    all[count + i] = Number(draw.limits[i], Child(limits_path, i));
  }
  if (HasNan(all)) return std::numeric_limits<double>::quiet_NaN();
  const Arguments plain(all, count, [](const Traced<double>& number) { return number.value(); });
  if (auto wrong = CheckArguments(draw.distribution, plain.numbers(), plain.limits())) {
    const auto stated = StatedInterval(draw.distribution, plain.numbers(), plain.limits());
    const bool empty = stated && stated->lo > stated->hi;
    return Fail(
        empty ? Code::kSampleEmptyRange : Code::kSampleBadArgument, mark, std::move(*wrong),
        empty ? "write the lower end first, or keep the ends apart with min() and max()" : "");
  }
  const double value = Known(draw.distribution, plain).At(Uniforms(path)[0]);
  if (!std::isfinite(value)) {
    return Fail(Code::kSampleBadArgument, mark,
                fmt::format("'{}' drew a value that is not finite", Info(draw.distribution).key));
  }
  if (!notes_) return value;
  return NoteDraw(draw.distribution, all, count, path, value);
}

// The first `count` are arguments, the others limits.
Traced<double> Evaluator::NoteDraw(Distribution distribution,
                                   std::span<const Traced<double>> arguments, std::size_t count,
                                   StreamId path, double value) {
  tape::Tape& tape = notes_->tape;
  double& at = tape.Keep(value);
  if (std::ranges::all_of(arguments, [](const auto& number) { return number.at() == nullptr; })) {
    const Arguments plain(arguments, count, [](const auto& number) { return number.value(); });
    tape.Add([this, path, &at, known = Known(distribution, plain)] {
      at = known.At(Uniforms(path)[0]);
      return std::isfinite(at);
    });
    return {value, tape, at};
  }
  std::vector<const double*> places;
  places.reserve(arguments.size());
  for (const Traced<double>& number : arguments) places.push_back(&tape::PlaceOf(tape, number));
  tape.Add([this, distribution, path, &at, places = tape.KeepAll(places), count] {
    const Arguments plain(places, count, [](const double* place) { return *place; });
    if (CheckArguments(distribution, plain.numbers(), plain.limits())) return false;
    at = Known(distribution, plain).At(Uniforms(path)[0]);
    return std::isfinite(at);
  });
  return {value, tape, at};
}

const spec::Value& Evaluator::OfRow(const spec::Draw& draw, SourceMark mark, StreamId& path) {
  const spec::RecordRows& rows = *draw.rows;
  const double key = Fixed(Variable(draw.key_slot));
  const auto row = std::isnan(key) ? rows.numbers.end() : rows.numbers.find(key);
  if (row == rows.numbers.end()) {
    if (!failed_) Fail(Code::kSampleBadArgument, mark, "no row has the key of this record");
    return draw.arguments.front();
  }
  path = Child(path, rows.names[row->second]);
  return draw.arguments[row->second];
}

const spec::Value& Evaluator::Chosen(const spec::Draw& draw, SourceMark mark, StreamId& path) {
  if (draw.rows != nullptr) return OfRow(draw, mark, path);
  const std::optional<Numbers> weights = Weights(draw, mark, path);
  std::size_t option = 0;
  if (weights) option = Option(draw, std::vector<double>(weights->begin(), weights->end()), path);
  if (weights && notes_) {
    tape::Tape& tape = notes_->tape;
    bool vary = false;
    std::vector<const double*> places;
    for (const Traced<double>& weight : *weights) {
      vary |= weight.tape() != nullptr;
      places.push_back(&tape::PlaceOf(tape, weight));
    }
    const auto test = [this, &draw, path, option, places = tape.KeepAll(places)] {
      std::vector<double> numbers;
      for (const double* place : places) numbers.push_back(*place);
      return WhatIsWrong(numbers).empty() && Option(draw, numbers, path) == option;
    };
    if (notes_->is_sampled_first && !vary) {
      tape.AddEarly(test);
    } else {
      tape.Add(test);
    }
  }
  path = Child(Child(path, Info(draw.distribution).key), option);
  return draw.arguments[option];
}

std::size_t Evaluator::Option(const spec::Draw& draw, std::span<const double> weights,
                              StreamId path) const {
  const std::size_t count = draw.arguments.size();
  if (draw.distribution == Distribution::kCycle) {
    return static_cast<std::size_t>(key_.index % count);
  }
  if (IsExact(draw)) {
    const std::vector<double> same(weights.empty() ? count : 0, 1);
    return sampler_->ExactOption(weights.empty() ? same : weights, key_, path);
  }
  const double u = Uniforms(path)[0];
  return weights.empty() ? static_cast<std::size_t>(u * static_cast<double>(count))
                         : WeightedIndex(weights, u);
}

std::optional<Numbers> Evaluator::Weights(const spec::Draw& draw, SourceMark mark, StreamId path) {
  Numbers weights;
  if (draw.weights.empty()) return weights;
  const StreamId weights_path = Child(path, "weights");
  for (std::size_t i = 0; i < draw.weights.size(); ++i) {
    weights.push_back(Number(draw.weights[i], ItemStream(draw.weights[i], weights_path, i)));
    if (!(weights.back().value() < 0)) continue;
    Fail(Code::kSampleBadArgument, draw.weights[i].mark,
         fmt::format("weight {} of the choice is {}; it must not be negative", i + 1,
                     NumberText(weights.back())));
    return std::nullopt;
  }
  if (HasNan({weights.data(), weights.size()}))
    return std::nullopt;  // reported where it was computed
  const std::string_view wrong = WhatIsWrong(std::vector<double>(weights.begin(), weights.end()));
  if (wrong.empty()) return weights;
  Fail(Code::kSampleBadArgument, mark, std::string(wrong));
  return std::nullopt;
}

void Evaluator::AppendRotation(StreamId path, Numbers& out) {
  const auto rotation = [this, path] {
    const std::array<double, 4> u = Uniforms(path);
    return UniformRotation(u[0], u[1], u[2]);
  };
  Append(tape::Note(tape(), rotation), out);
}

void Evaluator::AppendAbout(const spec::RotationAbout& about, SourceMark mark, StreamId path,
                            Numbers& out) {
  using Axis = std::array<double, 3>;
  Numbers axis;
  Vector(*about.axis, Child(path, "about"), axis);
  const auto length = [](const Axis& a) { return std::hypot(std::hypot(a[0], a[1]), a[2]); };
  const Traced<Axis> direction = tape::Gather<Axis>({axis.data(), axis.size()});
  if (tape::Test([length](const Axis& a) { return length(a) == 0; }, direction)) {
    Fail(Code::kSampleBadArgument, mark, "the axis to turn about is 0 0 0; it needs a direction");
  }
  const auto rotation = [this, path, length](const Axis& a) {
    // From -pi/2 to pi/2, so that w is not negative.
    const double half_angle = std::numbers::pi * (Uniforms(path)[0] - 0.5);
    std::array<double, 4> q = {std::cos(half_angle), 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) q[i + 1] = std::sin(half_angle) * (a[i] / length(a));
    return q;
  };
  Append(tape::Note(tape(), rotation, direction), out);
}

void Evaluator::AppendOnSphere(const spec::PointOnSphere& point, SourceMark mark, StreamId path,
                               Numbers& out) {
  const Traced<double> radius = Number(*point.radius, Child(path, "on_sphere"));
  if (radius < 0) {
    Fail(
        Code::kSampleBadArgument, mark,
        fmt::format("the radius of the sphere is {}; it must not be negative", NumberText(radius)));
  }
  const auto place = [this, path](double r) {
    const std::array<double, 4> u = Uniforms(path);
    std::array<double, 3> at = UniformDirection(u[0], u[1]);
    for (double& component : at) component *= r;
    return at;
  };
  Append(tape::Note(tape(), place, radius), out);
}

void Evaluator::AppendColor(const spec::HsvColor& color, SourceMark mark, StreamId path,
                            Numbers& out) {
  static constexpr std::array<std::string_view, 4> kNames = {"hue", "saturation", "value", "alpha"};
  Numbers items = {0.0, 0.0, 0.0, 1.0};  // opaque unless said
  for (std::size_t i = 0; i < color.items.size(); ++i) {
    items[i] = Number(color.items[i], ItemStream(color.items[i], path, i));
    if (items[i] < 0 || items[i] > 1) {
      Fail(Code::kSampleBadArgument, color.items[i].mark ? color.items[i].mark : mark,
           fmt::format("{} is {}; it must be between 0 and 1", kNames[i], NumberText(items[i])));
    }
    if (!(items[i].value() >= 0 && items[i].value() <= 1)) items[i] = 0.0;
  }
  Append(tape::Apply(HsvToRgb, items[0], items[1], items[2]), out);
  out.push_back(items[3]);
}

}  // namespace mjforge::sample
