// The page of a spec in a gallery: pictures, facts, features, parameters, commands.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/output/output.h"
#include "mjforge/report/gallery.h"
#include "mjforge/report/gallery_head.h"
#include "mjforge/report/page_sections.h"

namespace mjforge::report {
namespace {

constexpr std::uint64_t kSeed = 0x6d6a666f726765;  // seed of the draws for the charts
constexpr std::size_t kMaxColors = 48;             // largest number of swatches for a parameter

void AddPicture(Dictionary& parent, const char* section, const GalleryPicture& picture) {
  Dictionary& shown = Section(parent, section);
  SetPicture(shown, picture.image);
  Set(shown, "ALT", picture.alt);
  Set(shown, "CAPTION", picture.caption);
}

void AddPictures(Dictionary& body, const SpecPage& page) {
  if (page.large) AddPicture(body, "LARGE", *page.large);
  if (!page.tiles.empty()) {
    Dictionary& tiles = Section(body, "TILES");
    for (const GalleryPicture& tile : page.tiles) AddPicture(tiles, "TILE", tile);
  }
  if (page.films.empty()) return;
  Dictionary& films = Section(body, "FILMS");
  for (const Film& film : page.films) {
    Dictionary& shown = Section(films, "FILM");
    Set(shown, "JOINT", Clean(film.joint));
    for (const GalleryPicture& frame : film.frames) AddPicture(shown, "FRAME", frame);
  }
}

void AddFacts(Dictionary& parent, const char* section, const std::vector<Fact>& facts) {
  for (const auto& [key, value] : facts) {
    Dictionary& fact = Section(parent, section);
    Set(fact, "KEY", Clean(key));
    Set(fact, "VALUE", Clean(value));
  }
}

void AddFeatures(Dictionary& body, const std::vector<FeatureTable>& tables) {
  if (tables.empty()) return;
  Dictionary& features = Section(body, "FEATURES");
  for (const FeatureTable& table : tables) {
    Dictionary& shown = Section(features, "TABLE");
    Set(shown, "TITLE", table.title);
    AddFacts(shown, "ROW", table.rows);
  }
}

void AddCommands(Dictionary& body, const std::string& name) {
  const std::string spec = output::ShellWord(name);
  const std::string last = name.substr(name.rfind('/') + 1);
  const auto add = [&](std::string_view meaning, const std::string& text) {
    Dictionary& command = Section(body, "COMMAND");
    Set(command, "MEANING", meaning);
    Set(command, "TEXT", Clean(text, 1000));
  };
  add("Make 100 variants", fmt::format("mjforge generate {} -n 100 --seed 7 -o {}", spec,
                                       output::ShellWord(last + "/")));
  add("Change and see it", fmt::format("mjforge customize {}", spec));
  add("Start your own",
      fmt::format("mjforge new {} --like {}", output::ShellWord("my_" + last + ".yaml"), spec));
}

// Returns true if the values of a parameter are drawn; false if they are fixed, computed from other
// parameters, or columns of a drawn record.
bool IsDrawn(const spec::ObjectSpec& spec, const std::string& name) {
  const spec::Parameter* parameter = spec.FindParameter(name);
  if (parameter == nullptr) return false;
  const spec::Value& value = spec.ValueOf(*parameter);
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  return spec::HasDraw(value) && (draw == nullptr || draw->rows == nullptr);
}

void AddParameterSections(Dictionary& body, const Batch& batch) {
  const std::vector<ParameterTally>& all = batch.summary.params.list();
  if (all.empty()) return;
  const auto is_drawn = [&](const ParameterTally& tally) {
    return IsDrawn(*batch.recipe->spec, tally.name);
  };
  const auto drawn = static_cast<std::size_t>(std::ranges::count_if(all, is_drawn));
  Dictionary& section = Section(body, "PARAMETERS");
  if (drawn > 0) AddParameterPanels(Section(section, "DRAWN"), batch, is_drawn);
  if (drawn == all.size()) return;
  Dictionary& computed = Section(section, "COMPUTED");
  Set(computed, "COUNT", CountText(all.size() - drawn));
  AddParameterPanels(computed, batch,
                     [&](const ParameterTally& tally) { return !is_drawn(tally); });
}

// Returns the data of a batch that consists of the page's variants, for the sections of a report.
// Draws the parameters many more times for smooth charts.
Batch MakeBatch(SpecPage& page) {
  ManifestSummary summary(kMaxColors);
  for (const manifest::Record& record : page.variants) summary.Add(record);
  if (!summary.first) summary.first.emplace();
  Batch batch{std::move(summary), std::move(page.recipe), {}, {}, {}};
  batch.summary.params = DrawParameters(*batch.recipe->spec, {.seed = kSeed});
  return batch;
}

}  // namespace

std::string MakeSpecPage(SpecPage page) {
  ctemplate::TemplateDictionary body("spec");
  AddHead(body);
  const auto folders = std::ranges::count(GalleryPageFile(page.name), '/');
  std::string index;
  for (auto i = folders; i > 0; --i) index += "../";
  Set(body, "INDEX", index + "index.html");
  Set(body, "NAME", Clean(page.name));
  ShowText(body, "DESCRIPTION", Clean(page.recipe.spec->description, 1000));
  ShowNotices(body, page.notices);
  AddPictures(body, page);
  AddFacts(body, "FACT", page.facts);
  AddFeatures(body, page.features);
  AddCommands(body, page.name);
  const Batch batch = MakeBatch(page);
  AddParameterSections(body, batch);
  ShowSpecText(body, page.name + ".yaml", CleanSpec(page.text));
  return Expand(TemplateName::kSpec, body);
}

}  // namespace mjforge::report
