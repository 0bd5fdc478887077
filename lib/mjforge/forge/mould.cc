#include "mjforge/forge/mould.h"

#include <algorithm>

namespace mjforge::forge {
namespace {

constexpr std::size_t kMostMoulds = 64;
// What a mould takes, about: a step; a byte of the text, with its slots and with what it says in
// the object.
constexpr std::size_t kStepBytes = 100;
constexpr std::size_t kTextBytes = 8;
// Making a mould takes as long as several variants, so a family has to earn them: it may make some
// in advance, and then one more for each kPrice variants that came from moulds.
constexpr std::uint64_t kAdvance = 32;
constexpr std::uint64_t kPrice = 10;

}  // namespace

void Mould::Close(model::Object object, mjcf::MjcfDocument document, diag::Findings findings) {
  tape_.Close();
  bytes_ = kStepBytes * tape_.size() + kTextBytes * document.text.size();
  object_ = std::make_shared<model::Object>(std::move(object));
  model::TakeOffTape(*object_, links_);
  form_.emplace(std::move(document));
  findings_ = std::move(findings);
}

bool Mould::Make(Variant& variant) {
  if (object_.use_count() > 1 || !tape_.Run()) return false;
  links_.Update();
  form_->Fill(variant.record.index, variant.document);
  variant.object = object_;
  variant.findings.Append(diag::Findings(findings_));
  variant.mould = number;
  return true;
}

bool Moulds::Make(Variant& variant) {
  const auto found =
      std::ranges::find_if(moulds_, [&](const auto& mould) { return mould->Make(variant); });
  if (found == moulds_.end()) return false;
  ++hits_;
  std::rotate(moulds_.begin(), found, found + 1);
  return true;
}

std::unique_ptr<Mould> Moulds::Begin() {
  if (too_large_ || begun_ >= kAdvance + hits_ / kPrice) return nullptr;
  ++begun_;
  return std::make_unique<Mould>();
}

void Moulds::Add(std::unique_ptr<Mould> mould) {
  too_large_ = mould->bytes() > most_bytes_;
  if (too_large_) return;
  mould->number = ++made_;
  moulds_.insert(moulds_.begin(), std::move(mould));
  std::size_t bytes = 0;
  const auto last = std::ranges::find_if(moulds_, [&](const auto& one) {
    bytes += one->bytes();
    return bytes > most_bytes_;
  });
  const auto most =
      moulds_.begin() + static_cast<std::ptrdiff_t>(std::min(kMostMoulds, moulds_.size()));
  moulds_.erase(std::min(last, most), moulds_.end());
}

}  // namespace mjforge::forge
