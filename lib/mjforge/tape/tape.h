#pragma once

// Numbers that know how they were made. While one variant is made, a tape notes each step that
// depends on what was drawn; taking the steps again makes the numbers of another variant, as long
// as that one goes the same way.

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "mjforge/tape/traced.h"

namespace mjforge::tape {

// What a function takes may be traced or plain.
template <typename T>
const T& ValueOf(const T& value) {
  return value;
}
template <typename T>
const T& ValueOf(const Traced<T>& traced) {
  return traced.value();
}
template <typename T>
Tape* TapeOf(const T&) {
  return nullptr;
}
template <typename T>
Tape* TapeOf(const Traced<T>& traced) {
  return traced.tape();
}
template <typename T>
const T& PlaceOf(Tape& tape, const T& value) {
  return tape.Keep(value);
}
template <typename T>
const T& PlaceOf(Tape& tape, const Traced<T>& traced) {
  return traced.at() != nullptr ? *traced.at() : tape.Keep(traced.value());
}

/// What a tape's step works on.
template <typename... Args>
using Places = std::tuple<const std::remove_cvref_t<decltype(ValueOf(std::declval<Args>()))>&...>;

/// The tape that one of the values is on; null if none is.
template <typename... Args>
Tape* TapeOfAny(const Args&... args) {
  Tape* tape = nullptr;
  ((tape = tape != nullptr ? tape : TapeOf(args)), ...);
  return tape;
}

/// f(args...), noted if there is a tape or an argument is on one.
template <typename F, typename... Args>
auto Note(Tape* tape, F f, const Args&... args) {
  if (tape == nullptr) tape = TapeOfAny(args...);
  using Result = std::remove_cvref_t<decltype(f(ValueOf(args)...))>;
  Result result = f(ValueOf(args)...);
  if (tape == nullptr) return Traced<Result>(std::move(result));
  Result& at = tape->Keep(result);
  tape->Add([f, &at, places = Places<Args...>(PlaceOf(*tape, args)...)] {
    at = std::apply(f, places);
    return true;
  });
  return Traced<Result>(std::move(result), *tape, at);
}

/// f(args...), noted if an argument is on a tape. `f` must depend on nothing else that differs
/// between variants.
template <typename F, typename... Args>
auto Apply(F f, const Args&... args) {
  return Note(nullptr, std::move(f), args...);
}

/// Whether test(args...); noted, so that only variants with the same answer go this way.
template <typename F, typename... Args>
bool Test(F test, const Args&... args) {
  const bool answer = test(ValueOf(args)...);
  if (Tape* tape = TapeOfAny(args...)) {
    tape->Add([test, answer, places = Places<Args...>(PlaceOf(*tape, args)...)] {
      return static_cast<bool>(std::apply(test, places)) == answer;
    });
  }
  return answer;
}

/// The plain value; only variants that have the same go this way.
template <typename T>
T Fixed(const Traced<T>& traced) {
  Test([value = traced.value()](const T& other) { return other == value; }, traced);
  return traced.value();
}

/// A member of a struct.
template <typename S, typename M>
Traced<M> Member(const Traced<S>& whole, M S::*member) {
  if (whole.tape() == nullptr) return Traced<M>(whole.value().*member);
  return Traced<M>(whole.value().*member, *whole.tape(), whole.at()->*member);
}

/// One number of a vector, a matrix (by column) or a quaternion (x y z w).
template <typename V>
Traced<double> Element(const Traced<V>& whole, std::size_t i) {
  static_assert(sizeof(V) % sizeof(double) == 0);
  const double value = reinterpret_cast<const double*>(&whole.value())[i];
  if (whole.tape() == nullptr) return value;
  const double* at = whole.tape()->OriginOf(reinterpret_cast<const double*>(whole.at()) + i);
  return at == nullptr ? Traced<double>(value) : Traced<double>(value, *whole.tape(), *at);
}

/// A vector of as many numbers.
template <typename V>
Traced<V> Gather(std::span<const Traced<double>> numbers) {
  V value;
  static_assert(sizeof(V) % sizeof(double) == 0);
  auto* const plain = reinterpret_cast<double*>(&value);
  Tape* tape = nullptr;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    plain[i] = numbers[i];
    if (tape == nullptr) tape = numbers[i].tape();
  }
  if (tape == nullptr) return value;
  V& at = tape->Keep(value);
  auto* const out = reinterpret_cast<double*>(&at);
  std::array<const double*, sizeof(V) / sizeof(double)> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = numbers[i].tape() == nullptr ? &out[i] : numbers[i].at();
    tape->SetOrigin(&out[i], numbers[i].at());
  }
  tape->Add([out, places] {
    for (std::size_t i = 0; i < places.size(); ++i) out[i] = *places[i];
    return true;
  });
  return Traced<V>(value, *tape, at);
}

template <typename T>
concept Scalar = std::same_as<T, Traced<double>> || std::is_arithmetic_v<T>;
template <typename A, typename B>
concept TracedScalars = Scalar<A> && Scalar<B> &&
    (!std::is_arithmetic_v<A> || !std::is_arithmetic_v<B>);

template <typename A, typename B>
requires TracedScalars<A, B>
auto operator+(const A& a, const B& b) { return Apply(std::plus<double>(), a, b); }
template <typename A, typename B>
requires TracedScalars<A, B>
auto operator-(const A& a, const B& b) { return Apply(std::minus<double>(), a, b); }
template <typename A, typename B>
requires TracedScalars<A, B>
auto operator*(const A& a, const B& b) { return Apply(std::multiplies<double>(), a, b); }
template <typename A, typename B>
requires TracedScalars<A, B>
auto operator/(const A& a, const B& b) { return Apply(std::divides<double>(), a, b); }

// Comparisons are tests.
template <typename A, typename B>
requires TracedScalars<A, B>
bool operator==(const A& a, const B& b) { return Test(std::equal_to<double>(), a, b); }
template <typename A, typename B>
requires TracedScalars<A, B> std::partial_ordering operator<=>(const A& a, const B& b) {
  const std::partial_ordering order = static_cast<double>(a) <=> static_cast<double>(b);
  Test([order](double x, double y) { return (x <=> y) == order; }, a, b);
  return order;
}

}  // namespace mjforge::tape
