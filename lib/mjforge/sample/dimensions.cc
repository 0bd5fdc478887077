#include "mjforge/sample/dimensions.h"

#include <algorithm>
#include <span>

namespace mjforge::sample {
namespace {

using spec::Distribution;

// Above it, whole numbers have no neighbours to count.
constexpr double kMostLevels = 0x1p53;

class Walk {
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
    }
  }

  std::vector<DrawnStream> Take() { return std::move(streams_); }

 private:
  void Add(const DrawnStream& stream) { streams_.push_back(stream); }

  void Draw(const spec::Draw& draw, StreamId path) {
    const spec::DistributionInfo& info =
        spec::Distributions()[static_cast<std::size_t>(draw.distribution)];
    if (draw.distribution != Distribution::kCycle && !draw.exact) Add(Own(draw, path));
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

  // Items that are draws have streams of their own; what else there is in such a
  // list draws nothing.
  void Items(std::span<const spec::Value> items, StreamId path) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (std::holds_alternative<spec::Draw>(items[i].form)) Value(items[i], Child(path, i));
    }
  }

  static DrawnStream Own(const spec::Draw& draw, StreamId path) {
    DrawnStream stream = {.stream = path, .split = {}};
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

  std::vector<DrawnStream> streams_;
};

}  // namespace

std::vector<DrawnStream> DrawnStreams(const spec::ObjectSpec& spec) {
  const StreamId parameters = Child(RootStream(spec), "params");
  Walk walk;
  for (const spec::Parameter& parameter : spec.parameters) {
    walk.Value(parameter.value, Child(parameters, parameter.name));
  }
  return walk.Take();
}

}  // namespace mjforge::sample
