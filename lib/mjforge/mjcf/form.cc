#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

Form::Form(MjcfDocument document) : document_(std::move(document)), lift_(document_.lift.at()) {
  document_.lift = document_.lift.value();
  std::map<std::pair<const double*, Slot::Spelling>, std::size_t> known;
  for (const Slot& slot : document_.slots) {
    first_.push_back(known.try_emplace({slot.number, slot.spelling}, first_.size()).first->second);
  }
}

void Form::Fill(std::uint64_t index, MjcfDocument& document) {
  std::string& text = document.text;
  text.resize(document_.text.size() + expr::kLongestNumber * (first_.size() + 1));
  filled_.resize(first_.size());
  char* out = text.data();
  const auto write = [&out](const char* from, std::size_t count) {
    out = std::copy_n(from, count, out);
  };
  std::size_t from = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const Slot& slot = document_.slots[i];
    write(document_.text.data() + from, slot.begin - from);
    from = slot.end;
    const char* const begin = out;
    if (first_[i] < i) {
      const auto [first, end] = filled_[first_[i]];
      write(text.data() + first, end - first);
    } else if (slot.number == nullptr) {
      out = std::to_chars(out, out + expr::kLongestNumber, index).ptr;
    } else {
      out = WriteSpelled(*slot.number, slot.spelling, out);
    }
    filled_[i] = {begin - text.data(), out - text.data()};
  }
  write(document_.text.data() + from, document_.text.size() - from);
  text.resize(static_cast<std::size_t>(out - text.data()));
  document.slots.clear();
  document.origins = document_.origins;
  document.assets = document_.assets;
  document.made_files = document_.made_files;
  for (MadeFile& file : document.made_files) file.hash = Moved(file.hash);
  document.size_position = Moved(document_.size_position);
  document.world_position = Moved(document_.world_position);
  document.host_frees = document_.host_frees;
  document.lift = lift_ == nullptr ? document_.lift.value() : *lift_;
}

std::size_t Form::Moved(std::size_t position) const {
  if (position == std::string::npos) return position;
  const auto behind = std::ranges::upper_bound(document_.slots, position, {}, &Slot::begin);
  if (behind == document_.slots.begin()) return position;
  const auto last = static_cast<std::size_t>(behind - document_.slots.begin()) - 1;
  return position - document_.slots[last].end + filled_[last].second;
}

}  // namespace mjforge::mjcf
