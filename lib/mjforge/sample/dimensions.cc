// Collection of the random streams of a spec's parameters, by a recursive visit of the values of
// the parameters.

#include "mjforge/sample/dimensions.h"

#include <algorithm>
#include <span>

namespace mjforge::sample {
namespace {

using spec::Distribution;

// Limit for the number of levels of an integer draw: every whole number up to 2^53 is exact as a
// double.
constexpr double kMostLevels = 0x1p53;

class StreamCollector {
 public:
  void Value(const spec::Value& value, StreamId path) {
    if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
      Draw(*draw, path);
    } else if (const auto* list = std::get_if<spec::List>(&value.form)) {
      Items(list->items, path);
    } else if (const auto* color = std::get_if<spec::HsvColor>(&value.form)) {
      Items(color->items, path);
    } else if (std::holds_alternative<spec::RandomRotation>(value.form)) {
      Add({.stream = path, .numbers = 3, .split = {}});
    } else if (const auto* about = std::get_if<spec::RotationAbout>(&value.form)) {
      Add({.stream = path, .split = {}});
      Value(*about->axis, Child(path, "about"));
    } else if (const auto* point = std::get_if<spec::PointOnSphere>(&value.form)) {
      Add({.stream = path, .numbers = 2, .split = {}});
      Value(*point->radius, Child(path, "on_sphere"));
    } else if (const auto* each = std::get_if<spec::Each>(&value.form)) {
      Each(*each, path);
    } else if (const auto* arrangement = std::get_if<spec::Arrangement>(&value.form)) {
      Arrangement(*arrangement, path);
    }
  }

  std::vector<ParameterStream> Take() { return std::move(streams_); }

 private:
  void Add(const ParameterStream& stream) { streams_.push_back(stream); }

  // Returns the length of a list as an integer if `count` is a constant and a valid length;
  // otherwise 0.
  static std::size_t LengthOf(const spec::Value& count) {
    const double number = spec::ConstantOf(count).value_or(0);
    return spec::IsListLength(number) ? static_cast<std::size_t>(number) : 0;
  }

  void Each(const spec::Each& each, StreamId path) {
    for (std::size_t i = 0; i < LengthOf(*each.count); ++i) Value(*each.value, Child(path, i));
  }

  void Arrangement(const spec::Arrangement& arrangement, StreamId path) {
    const auto* list = std::get_if<spec::List>(&arrangement.list->form);
    for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i)
      Add({.stream = Child(path, i), .is_order = true, .split = {}});
    Value(*arrangement.list, Child(path, "items"));
  }

  void Draw(const spec::Draw& draw, StreamId path) {
    for (std::size_t i = 0; draw.rows != nullptr && i < draw.arguments.size(); ++i)
      Value(draw.arguments[i], Child(path, draw.rows->names[i]));
    if (draw.rows != nullptr) return;
    const spec::DistributionInfo& info =
        spec::Distributions()[static_cast<std::size_t>(draw.distribution)];
    if (draw.distribution != Distribution::kCycle && !draw.exact) Add(OwnStream(draw, path));
    if (info.arguments < 0) {
      Items(draw.weights, Child(path, info.option));
      const StreamId options = Child(path, info.key);
      for (std::size_t i = 0; i < draw.arguments.size(); ++i) {
        Value(draw.arguments[i], Child(options, i));
      }
    } else {
      Items(draw.arguments, path);
      Items(draw.limits, Child(path, info.option));
    }
  }

  // Adds the streams of items that are draws; other items of a list draw nothing.
  void Items(std::span<const spec::Value> items, StreamId path) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (std::holds_alternative<spec::Draw>(items[i].form)) Value(items[i], Child(path, i));
    }
  }

  // Returns the stream of a draw, without the streams of draws in its arguments.
  static ParameterStream OwnStream(const spec::Draw& draw, StreamId path) {
    ParameterStream stream = {.stream = path, .split = {}};
    if (draw.distribution == Distribution::kChoice && draw.weights.empty()) {
      stream.levels = draw.arguments.size();
    } else if (draw.distribution == Distribution::kInteger) {
      const auto lo = spec::ConstantOf(draw.arguments[0]);
      const auto hi = spec::ConstantOf(draw.arguments[1]);
      if (lo && hi && *hi - *lo < kMostLevels) {
        stream.levels = static_cast<std::uint64_t>(std::max(0.0, *hi - *lo + 1));
      }
    } else if (draw.distribution == Distribution::kBernoulli) {
      stream.levels = 2;
      stream.split = spec::ConstantOf(draw.arguments[0]);
      if (stream.split && !(*stream.split > 0 && *stream.split < 1)) {
        stream.levels = 1;
        stream.split.reset();
      }
    }
    return stream;
  }

  std::vector<ParameterStream> streams_;
};

}  // namespace

std::vector<ParameterStream> ParameterStreams(const spec::ObjectSpec& spec) {
  StreamCollector collector;
  const auto add = [&collector](const spec::ObjectSpec& of, StreamId root) {
    const StreamId parameters = Child(root, "params");
    for (const spec::Parameter& parameter : of.parameters)
      collector.Value(parameter.value, Child(parameters, parameter.name));
  };
  for (const auto& shared : spec.shared) add(*shared, SharedStream(*shared));
  add(spec, RootStream(spec));
  return collector.Take();
}

}  // namespace mjforge::sample
