#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/record_fields.h"

namespace mjforge::manifest {
namespace {

constexpr std::size_t kMostForms = 8;
// Making a form takes as long as writing two records, so forms have to earn new ones.
constexpr std::uint64_t kAdvance = 16;
constexpr std::uint64_t kPrice = 4;

// Where a number stands in the text of a form. No JSON has this byte.
constexpr char kMark = '\0';
void AppendMark(std::string& out, double) { out += kMark; }

void WriteMembers(diag::Json& json, std::span<const RecordField> fields, const Record& record) {
  for (const RecordField& field : fields) {
    if (field.is_absent != nullptr && field.is_absent(record)) continue;
    json.Key(field.key);
    field.write(json, record);
  }
}

// Those that differ in numbers only, in most records of a batch, and those before and after them:
// how many geoms there are may be drawn.
struct Fields {
  std::span<const RecordField> before, alike, after;

  Fields() {
    const auto all = RecordFields();
    const auto is = [](std::string_view key) {
      return [key](const RecordField& field) { return field.key == key; };
    };
    const auto begin = std::ranges::find_if(all, is("spec"));
    const auto end = std::ranges::find_if(all, is("horizontal_radius")) + 1;
    before = {all.begin(), begin};
    alike = {begin, end};
    after = {end, all.end()};
  }
};

const Fields& AllFields() {
  static const Fields kFields;
  return kFields;
}

// Appends a line; `write_alike` writes the fields that are alike.
template <typename WriteAlike>
void AppendLine(std::string& out, const Record& record, WriteAlike write_alike) {
  diag::Json json(expr::AppendExactNumber, std::move(out));
  json.StartObject();
  WriteMembers(json, AllFields().before, record);
  write_alike(json);
  WriteMembers(json, AllFields().after, record);
  json.EndObject();
  out = json.Take();
  out += '\n';
}

bool AreSame(double a, double b) {  // -0 is not 0
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

// The text of the fields that are alike, for records that differ from one in numbers only.
class RecordWriter::Form {
 public:
  Form(const Record& record, std::span<const double> numbers);

  bool Fits(const Record& record) const {
    return std::ranges::all_of(
        AllFields().alike, [&](const RecordField& field) { return field.is_alike(record, like_); });
  }
  std::string_view Fill(std::span<const double> numbers);

 private:
  struct Slot {
    std::size_t before = 0;  // bytes of the text between the slot before it and this one
    std::size_t twin = 0;    // the first slot with the same number in the record of the form
    double number = 0;       // as it was spelled last
    std::size_t size = 0;
    std::array<char, expr::kLongestNumber> spelled = {};
  };

  static void Spell(Slot& slot, double number) {
    slot.number = number;
    const char* const end = expr::WriteExactNumber(slot.spelled.data(), number);
    slot.size = static_cast<std::size_t>(end - slot.spelled.data());
  }

  Record like_;
  std::string text_;
  std::vector<Slot> slots_;
  std::string filled_;
};

RecordWriter::Form::Form(const Record& record, std::span<const double> numbers) : like_(record) {
  diag::Json json(AppendMark);
  json.StartObject();
  WriteMembers(json, AllFields().alike, record);
  text_ = json.Take().substr(1);  // without the bracket
  slots_.reserve(numbers.size());
  std::size_t from = 0;
  for (const double number : numbers) {
    const auto twin = std::ranges::find_if(
        slots_, [number](const Slot& slot) { return AreSame(slot.number, number); });
    const std::size_t mark = text_.find(kMark, from);
    slots_.push_back(
        {.before = mark - from, .twin = static_cast<std::size_t>(twin - slots_.begin())});
    Spell(slots_.back(), number);
    from = mark + 1;
  }
  std::erase(text_, kMark);
  filled_.resize(text_.size() + expr::kLongestNumber * slots_.size());
}

std::string_view RecordWriter::Form::Fill(std::span<const double> numbers) {
  const char* from = text_.data();
  char* out = filled_.data();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    out = std::copy_n(from, slot.before, out);
    from += slot.before;
    if (!AreSame(slot.number, numbers[i])) {
      const Slot& twin = slots_[slot.twin];
      if (AreSame(twin.number, numbers[i])) {
        slot.number = twin.number;
        slot.size = twin.size;
        slot.spelled = twin.spelled;
      } else {
        Spell(slot, numbers[i]);
      }
    }
    out = std::copy_n(slot.spelled.data(), slot.size, out);
  }
  out = std::copy(from, std::as_const(text_).data() + text_.size(), out);
  return {filled_.data(), out};
}

RecordWriter::RecordWriter() = default;
RecordWriter::~RecordWriter() = default;

RecordWriter::Form* RecordWriter::FormOf(const Record& record) {
  numbers_.clear();
  for (const RecordField& field : AllFields().alike) field.numbers(record, numbers_);
  // What is not finite is null in JSON.
  if (!std::ranges::all_of(numbers_, [](double number) { return std::isfinite(number); }))
    return nullptr;
  const auto found =
      std::ranges::find_if(forms_, [&](const auto& form) { return form->Fits(record); });
  if (found != forms_.end()) {
    ++hits_;
    std::rotate(forms_.begin(), found, found + 1);
  } else {
    if (made_ >= kAdvance + hits_ / kPrice) return nullptr;
    ++made_;
    if (forms_.size() == kMostForms) forms_.pop_back();
    forms_.insert(forms_.begin(), std::make_unique<Form>(record, numbers_));
  }
  return forms_.front().get();
}

void RecordWriter::Append(std::string& out, const Record& record) {
  Form* const form = FormOf(record);
  if (form == nullptr) return AppendRecord(out, record);
  AppendLine(out, record, [&](diag::Json& json) { json.Raw(form->Fill(numbers_)); });
}

void AppendRecord(std::string& out, const Record& record) {
  AppendLine(out, record, [&](diag::Json& json) { WriteMembers(json, AllFields().alike, record); });
}

}  // namespace mjforge::manifest
