// Expansion of the HTML templates of reports and galleries by ctemplate, and formatting of the
// values that are filled in.

#include "mjforge/report/templates.h"

#include <ctemplate/template.h>
#include <fmt/format.h>

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "mjforge/diag/diag.h"

namespace mjforge::report {

extern const std::string_view kPageHtml;
extern const std::string_view kRowHtml;
extern const std::string_view kHistogramHtml;
extern const std::string_view kBarsHtml;
extern const std::string_view kScatterHtml;
extern const std::string_view kPanelsHtml;
extern const std::string_view kGalleryHtml;
extern const std::string_view kSpecHtml;

namespace {

struct Template {
  const char* name;
  const std::string_view& text;
};
// All templates, in the order of TemplateName.
const Template kTemplates[] = {{"page", kPageHtml},           {"row", kRowHtml},
                               {"histogram", kHistogramHtml}, {"bars", kBarsHtml},
                               {"scatter", kScatterHtml},     {"panels", kPanelsHtml},
                               {"gallery", kGalleryHtml},     {"spec", kSpecHtml}};

const char* NameOf(TemplateName name) { return kTemplates[static_cast<std::size_t>(name)].name; }

ctemplate::TemplateString View(std::string_view text) {
  return ctemplate::TemplateString(text.data(), text.size());
}

// Registers all templates in ctemplate's cache. Must be called once per process.
bool LoadTemplates() {
  return std::ranges::all_of(kTemplates, [](const Template& each) {
    return ctemplate::StringToTemplateCache(each.name, View(each.text),
                                            ctemplate::STRIP_BLANK_LINES);
  });
}

}  // namespace

std::string Expand(TemplateName name, const Dictionary& dictionary) {
  static const bool kLoaded = LoadTemplates();
  std::string text;
  if (!kLoaded ||
      !ctemplate::ExpandTemplate(NameOf(name), ctemplate::STRIP_BLANK_LINES, &dictionary, &text)) {
    return {};
  }
  return text;
}

Dictionary& Include(Dictionary& parent, const char* marker, TemplateName name) {
  Dictionary& chart = *parent.AddIncludeDictionary(marker);
  chart.SetFilename(NameOf(name));
  return chart;
}

void Set(Dictionary& dictionary, const char* name, std::string_view value) {
  dictionary.SetValue(name, View(value));
}

void Set(Dictionary& dictionary, const char* name, double place) {
  Set(dictionary, name, fmt::format("{:.1f}", place));
}

void ShowText(Dictionary& parent, const char* section, std::string_view text) {
  if (!text.empty()) Set(Section(parent, section), "TEXT", text);
}

std::string Clean(std::string_view text, std::size_t limit) {
  std::string clean = diag::SafeText(text.substr(0, limit + 4));
  if (clean.size() <= limit) return clean;
  std::size_t end = limit;
  while (end > 0 && diag::IsContinuation(clean[end])) --end;
  return clean.substr(0, end) + "...";
}

std::string CleanSpec(std::string_view text) {
  constexpr std::size_t kMaxBytes = 100'000;
  std::string clean;
  if (text.size() > kMaxBytes) return clean;
  while (!text.empty()) {
    std::string_view line = diag::CutAt('\n', text);
    if (line.ends_with('\r')) line.remove_suffix(1);
    clean += Clean(line, 2000) + '\n';
  }
  return clean;
}

std::string Base64(std::string_view bytes) {
  namespace iterators = boost::archive::iterators;
  using Digits = iterators::base64_from_binary<iterators::transform_width<const char*, 6, 8>>;
  std::string text(Digits(bytes.data()), Digits(bytes.data() + bytes.size()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

void SetPicture(Dictionary& picture, const Thumbnail& image) {
  Set(picture, "DATA", "data:image/webp;base64," + Base64(image.webp));
  Set(picture, "WIDTH", fmt::format("{}", image.width));
  Set(picture, "HEIGHT", fmt::format("{}", image.height));
}

std::string CountText(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, ",");
  return digits;
}

std::string CountText(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", CountText(number), noun, number == 1 ? "" : "s");
}

double Share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string ShareText(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "0 %";
  if (part == 0 || part == whole) return part == 0 ? "0 %" : "100 %";
  return fmt::format("{:.1f} %", std::clamp(100 * Share(part, whole), 0.1, 99.9));
}

}  // namespace mjforge::report
