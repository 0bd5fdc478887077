#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <new>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace mjforge::tape {

/// The steps of one variant, and the memory in which they leave their results.
class Tape {
 public:
  Tape() = default;
  Tape(const Tape&) = delete;
  Tape& operator=(const Tape&) = delete;

  /// A copy of `value` that stays where it is as long as the tape.
  template <typename T>
  T& Keep(T value) {
    if constexpr (std::is_trivially_destructible_v<T>) {
      return *new (memory_.allocate(sizeof(T), alignof(T))) T(std::move(value));
    } else {
      auto kept = std::make_shared<T>(std::move(value));
      kept_.push_back(kept);
      return *kept;
    }
  }

  /// The same of a list of plain values.
  template <typename List>
  auto KeepAll(const List& values) {
    using T = typename List::value_type;
    static_assert(std::is_trivially_destructible_v<T>);
    T* first = static_cast<T*>(memory_.allocate(values.size() * sizeof(T), alignof(T)));
    std::uninitialized_copy(values.begin(), values.end(), first);
    return std::span<T>(first, values.size());
  }

  /// Adds a step: `take` is called without arguments. If it returns false, the variant goes another
  /// way than the one that was noted, and the tape is of no use for it.
  template <typename Take>
  void Add(Take take) {
    steps_.push_back(StepOf(std::move(take)));
  }

  /// Adds a step that needs no result of another, to be taken before them: most variants that go
  /// another way are recognised by these.
  template <typename Take>
  void AddEarly(Take take) {
    early_.push_back(StepOf(std::move(take)));
  }

  /// Takes all steps in order; false as soon as one of them goes another way.
  bool Run() const;

  std::size_t size() const { return early_.size() + steps_.size(); }
  /// After the last step was added: frees what only adding needs.
  void Close() { origins_.clear(); }

  /// Notes that the number at `copy` always equals the one at `original`, or, if that is null, is
  /// constant.
  void SetOrigin(const double* copy, const double* original);
  /// Where a number on the tape was first made; null if it is constant.
  const double* OriginOf(const double* number) const;

 private:
  struct Step {
    bool (*take)(void*);
    void* state;
  };
  template <typename Take>
  Step StepOf(Take take) {
    return {[](void* step) { return (*static_cast<Take*>(step))(); }, &Keep(std::move(take))};
  }

  std::pmr::monotonic_buffer_resource memory_;
  std::vector<std::shared_ptr<void>> kept_;
  std::vector<Step> early_;
  std::vector<Step> steps_;
  std::unordered_map<const double*, const double*> origins_;
};

/// A value, and where a tape finds that of another variant: nowhere if it is the same for all. It
/// reads as the value itself. To change it, assign a whole one: no tape notices a change of an
/// element alone.
template <typename T>
class Traced : public T {
 public:
  Traced() = default;
  Traced(const T& value) : T(value) {}
  template <typename Other>
  requires(!std::derived_from<Other, T> && std::convertible_to<const Other&, T>)
      Traced(const Other& other)
      : T(other) {}
  /// Of a vector or a quaternion, by its numbers.
  template <std::convertible_to<double>... Numbers>
  requires(sizeof...(Numbers) > 1) Traced(const Numbers&... numbers) : T(numbers...) {}
  Traced(const T& value, Tape& tape, const T& at) : T(value), tape_(&tape), at_(&at) {}

  const T& value() const { return *this; }
  Tape* tape() const { return tape_; }
  const T* at() const { return at_; }
  /// From now on it is plain, and may be changed through the pointer.
  T* Release() {
    tape_ = nullptr;
    at_ = nullptr;
    return this;
  }

 private:
  Tape* tape_ = nullptr;
  const T* at_ = nullptr;
};

/// One number.
template <>
class Traced<double> {
 public:
  Traced() = default;
  Traced(double value) : value_(value) {}
  Traced(double value, Tape& tape, const double& at) : value_(value), tape_(&tape), at_(&at) {}

  const double& value() const { return value_; }
  operator double() const { return value_; }
  Tape* tape() const { return tape_; }
  const double* at() const { return at_; }
  double* Release() {
    tape_ = nullptr;
    at_ = nullptr;
    return &value_;
  }

 private:
  double value_ = 0;
  Tape* tape_ = nullptr;
  const double* at_ = nullptr;
};

/// Values that follow a tape: they were traced, and get what later runs make of them.
class Links {
 public:
  /// Takes the value off its tape, if it is on one. It must stay where it is.
  template <typename T>
  void Take(Traced<T>& traced) {
    const T* from = traced.at();
    T* const to = traced.Release();
    if (from == nullptr) return;
    constexpr std::size_t kNumber = sizeof(double);
    static_assert(sizeof(T) % kNumber == 0);
    links_.push_back({reinterpret_cast<const double*>(from), reinterpret_cast<double*>(to),
                      sizeof(T) / kNumber});
  }
  /// After a run of the tape.
  void Update() const;

 private:
  struct Link {
    const double* from;
    double* to;
    std::size_t count;
  };
  std::vector<Link> links_;
};

}  // namespace mjforge::tape
