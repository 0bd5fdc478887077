// Expansion of repeated entries: counting in advance, conditions and local values of instances.

#include "mjforge/assemble/repetition.h"

#include <fmt/format.h>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Limit on the number of instances of all kinds in one object, including those that `if` leaves
// out. The limit is larger than kMaxParts, because a condition may leave out most instances (a ball
// of cells cut from a cube).
constexpr long kMaxSteps = 1'000'000;

bool SetLocals(const spec::Entry& entry, sample::Evaluator& values, sample::StreamId list) {
  if (entry.locals.empty()) return true;
  const std::optional<std::string> name = values.Text(entry.name, list);
  if (!name) return false;
  const sample::StreamId path = sample::Child(sample::Child(list, std::string_view(*name)), "let");
  bool is_good = true;
  for (const spec::Local& local : entry.locals)
    is_good &= values.SetLocal(local, sample::Child(path, std::string_view(local.name)));
  return is_good;
}

}  // namespace

long Repetition::CountInstances(const spec::Entry& entry, std::size_t depth,
                                sample::Evaluator& values, long limit) {
  const spec::Loop& loop = entry.loops[depth];
  const std::optional<sample::LoopRange> range = values.RangeOf(loop);
  if (!range) return -1;
  const auto times = static_cast<long>(range->count);
  if (depth + 1 == entry.loops.size()) return times;
  long sum = 0;
  for (long i = 0; i < times && sum <= limit; ++i) {
    // Limits the outer loops, too, which take time even if the inner loops have no instances.
    if (i > kMaxSteps) return limit + 1;
    values.SetVariable(loop, *range, static_cast<std::size_t>(i));
    const long inner = CountInstances(entry, depth + 1, values, limit - sum);
    if (inner < 0) return -1;
    sum += inner;
  }
  return sum;
}

std::optional<std::size_t> Repetition::Count(const spec::Entry& entry, sample::Evaluator& values,
                                             std::size_t existing) {
  if (steps_ > kMaxSteps) return std::nullopt;  // already reported
  if (entry.loops.empty()) {
    if (++steps_ <= kMaxSteps) return 1;
    findings_.Add(Code::kModelTooManyParts, entry.mark,
                  fmt::format("the object has more than {} elements", kMaxSteps));
    return std::nullopt;
  }
  const bool some_missing = entry.condition.has_value() || entry.is_frame;
  const long limit =
      some_missing ? kMaxSteps - steps_ : model::kMaxParts - static_cast<long>(existing);
  const long count = CountInstances(entry, 0, values, limit);
  if (count < 0) return std::nullopt;
  steps_ += count;
  if (count <= limit && steps_ <= kMaxSteps) return static_cast<std::size_t>(count);
  findings_.Add(Code::kModelTooManyParts, entry.loops.front().range.mark,
                fmt::format("'for' makes more instances than the {} parts an object may have",
                            model::kMaxParts));
  return std::nullopt;
}

bool Repetition::Walk(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
                      sample::StreamId list, const std::function<void()>& visit) {
  const std::size_t before = findings_.size();
  if (depth == entry.loops.size()) {
    const bool locals_first = entry.condition_uses_locals;
    bool exists = !locals_first || SetLocals(entry, values, list);
    if (exists && entry.condition)
      exists = values.Condition(*entry.condition, entry.mark).value_or(false);
    // Sets the local values after the condition, because the values of an instance that does not
    // exist may be impossible to compute.
    if (exists && !locals_first) exists = SetLocals(entry, values, list);
    if (exists) visit();
    return !findings_.HasErrors(before);
  }
  const spec::Loop& loop = entry.loops[depth];
  const std::optional<sample::LoopRange> range = values.RangeOf(loop);
  for (std::size_t i = 0; range && i < range->count; ++i) {
    values.SetVariable(loop, *range, i);
    if (!Walk(entry, depth + 1, values, list, visit)) return false;
  }
  return true;
}

}  // namespace mjforge::assemble
