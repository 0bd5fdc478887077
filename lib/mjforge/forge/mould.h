#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// What variants share if all conditions, counts and choices come out alike: the steps that make
/// their numbers, the object that holds them, the text around them.
class Mould {
 public:
  /// To make the first variant on.
  tape::Tape& tape() { return tape_; }
  /// The first variant is made.
  void Close(model::Object object, mjcf::MjcfDocument document, diag::Findings findings);
  std::shared_ptr<const model::Object> object() const { return object_; }
  /// About how much memory it takes.
  std::size_t bytes() const { return bytes_; }

  /// Makes the variant whose parameters were drawn last. False if it goes another way, or if
  /// someone still has the object of an earlier one.
  bool Make(Variant& variant);

  std::uint64_t number = 0;  // from 1 up, in the order of their making

 private:
  tape::Tape tape_;
  std::shared_ptr<model::Object> object_;
  tape::Links links_;
  std::optional<mjcf::Form> form_;
  diag::Findings findings_;
  std::size_t bytes_ = 0;
};

/// The moulds of one family, the one used last first.
class Moulds {
 public:
  explicit Moulds(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  bool Make(Variant& variant);
  /// A mould for a variant that none of them could make; null if another one would not pay.
  std::unique_ptr<Mould> Begin();
  void Add(std::unique_ptr<Mould> mould);

 private:
  std::size_t most_bytes_;
  std::vector<std::unique_ptr<Mould>> moulds_;
  bool too_large_ = false;   // a mould of this family
  std::uint64_t begun_ = 0;  // moulds
  std::uint64_t made_ = 0;   // of those
  std::uint64_t hits_ = 0;   // variants from them
};

}  // namespace mjforge::forge
