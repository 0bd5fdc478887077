// Answers to the requests of the page of `mjforge customize`, one function per action.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>

#include "mjforge/customize/controls.h"
#include "mjforge/customize/customize.h"
#include "mjforge/customize/findings_json.h"
#include "mjforge/customize/mjcf_archive.h"
#include "mjforge/customize/moved_joints.h"
#include "mjforge/customize/page_request.h"
#include "mjforge/customize/presets.h"
#include "mjforge/customize/variant_cache.h"
#include "mjforge/customize/variant_json.h"
#include "mjforge/physics/physics.h"

namespace mjforge::customize {
namespace {

constexpr int kQuality = 85;
constexpr int kQuickQuality = 70;
// Limits of a film: largest number of frames, and shortest time for which a frame is shown, ms.
constexpr std::size_t kMostFrames = 24;
constexpr int kShortestFrame = 40;

// Writes the settings of a recipe as a list of objects with `name` and `text`.
void WriteSettings(diag::Json& json, const std::optional<forge::Recipe>& recipe) {
  json.Each("settings", recipe ? recipe->settings : decltype(recipe->settings)(),
            [&](const auto& setting) {
              json.Member("name", setting.first);
              json.Member("text", setting.second);
            });
}

// Copies an image into one of the nine cells (three rows of three) of a larger image.
void PutInCell(const picture::Image& tile, int cell, picture::Image& image) {
  const int left = cell % 3 * tile.width;
  const int top = cell / 3 * tile.height;
  for (int y = 0; y < tile.height; ++y)
    std::copy_n(tile.rgba.data() + 4 * y * tile.width, 4 * tile.width,
                image.rgba.data() + 4 * ((top + y) * image.width + left));
}

// Returns a reply without a picture; `write` adds the members of its JSON object.
template <typename Write>
Reply JsonReply(const Write& write) {
  return {diag::JsonObject(expr::AppendExactNumber, write), {}, {}};
}

Reply Failure(std::string_view message) {
  return JsonReply([&](diag::Json& json) { json.Member("error", diag::SafeText(message)); });
}

// Returns the reason why a variant has no picture: "index 3 failed: size of part 'rod' is 0".
std::string FailureText(std::uint64_t index, const diag::Findings& findings) {
  const diag::Finding* const error = findings.FirstError();
  return fmt::format("index {} failed: {}", index,
                     error == nullptr ? "no picture" : diag::SafeText(error->message));
}

// Returns the description of a film of the drop or, if `joint` is not empty, of the drive of this
// joint: "Drop, 0.25 s, shown 5.1 times slower". `time` is the simulated and `shown` the shown
// time, s.
std::string FilmText(const std::string& joint, double time, double shown) {
  constexpr double kSlow = 1.1;  // smallest factor that the text mentions
  const std::string slower =
      shown > kSlow * time ? fmt::format(", shown {:.1f} times slower", shown / time) : "";
  return fmt::format("{}, {:.2f} s{}", joint.empty() ? "Drop" : "Drive of " + diag::SafeText(joint),
                     time, slower);
}

}  // namespace

struct Studio::State {
  explicit State(Start given)
      : start(std::move(given)), cache(start.reference, start.load.search_path, start.place_seed) {}

  Reply Answer(const Request& request);
  Reply Open(const Request& request);
  Reply Draw(const Request& request);
  Reply Check(const Request& request);
  Reply Film(const Request& request);
  Reply Redraw(Request request);
  Reply Export(const Request& request);
  Reply Source(const Request& request);
  Reply Pick(const Request& request);
  Reply SavePreset(const Request& request);
  Reply LoadPreset(const Request& request);
  Presets PresetsOf(const ShownVariant& shown) const;
  std::optional<picture::Image> DrawNine(const Request& request, std::vector<std::string>& texts);
  std::optional<picture::Image> DrawPicture(const Request& request, ShownVariant& shown,
                                            diag::Findings& findings);

  Start start;
  VariantCache cache;
  std::unique_ptr<picture::Renderer> renderer;
  physics::Laboratory laboratory;
};

Studio::Studio(Start start) : state_(std::make_unique<State>(std::move(start))) {}
Studio::~Studio() = default;

Reply Studio::Answer(std::string_view request) {
  std::string why_not;
  std::optional<Request> wanted = ReadRequest(request, why_not);
  if (!wanted) return Failure(why_not);
  try {
    state_->cache.QuoteTexts(*wanted);
    return state_->Answer(*wanted);
  } catch (const std::bad_alloc&) {
    throw;  // ends the process, which frees its memory
  } catch (const std::exception& error) {
    return Failure(error.what());
  }
}

Reply Studio::State::Answer(const Request& request) {
  if (request.action == "open") return Open(request);
  if (request.action == "draw") return Draw(request);
  if (request.action == "check") return Check(request);
  if (request.action == "film") return Film(request);
  if (request.action == "redraw") return Redraw(request);
  if (request.action == "export") return Export(request);
  if (request.action == "source") return Source(request);
  if (request.action == "pick") return Pick(request);
  if (request.action == "save") return SavePreset(request);
  if (request.action == "preset") return LoadPreset(request);
  return Failure("there is no action '" + request.action + "'");
}

// Loads the spec without settings to describe its controls, because settings would hide the ranges
// and choices of the spec.
Reply Studio::State::Open(const Request& request) {
  diag::Sources sources;
  diag::Findings findings;
  const bool is_set = !start.load.settings.empty() || !start.load.parameter_files.empty();
  std::optional<forge::Recipe> first;
  if (is_set) first = forge::LoadRecipe(start.reference, start.load, sources, findings);
  Request bare = request;
  bare.settings.clear();
  ShownVariant& shown = cache.LoadSpec(bare);
  Reply reply = JsonReply([&](diag::Json& json) {
    json.Member("layers", picture::LayerNames());
    json.Member("seed", std::to_string(start.seed));
    json.Member("index", std::to_string(start.index));
    WriteSettings(json, first);
    json.Member("name", shown.recipe ? shown.recipe->spec->name : start.reference);
    json.Member("description", shown.recipe ? diag::SafeText(shown.recipe->spec->description) : "");
    json.Key("controls");
    if (shown.recipe)
      WriteControls(json, *shown.recipe->spec);
    else
      json.Value(nullptr);
    json.Key("view");
    json.Raw(spec::ViewJson(shown.recipe ? shown.recipe->spec->view : spec::PictureView()));
    json.Member("presets", shown.recipe ? PresetsOf(shown).List() : std::vector<std::string>());
    if (findings.HasErrors())
      WriteFindings(json, findings, sources);
    else
      WriteFindings(json, shown.spec_findings, shown.sources);
  });
  reply.files = cache.Files();
  return reply;
}

// Returns the presets beside the spec's file; for specs of the search path, whose folders may not
// be writable, those in the working folder.
Presets Studio::State::PresetsOf(const ShownVariant& shown) const {
  const std::filesystem::path& file = shown.recipe->file;
  return {file.parent_path(), std::filesystem::path(start.reference).stem().string()};
}

Reply Studio::State::SavePreset(const Request& request) {
  const ShownVariant& shown = cache.LoadSpec(request);
  if (!Presets::IsValidName(request.name))
    return Failure("'" + request.name + "' is no name for a file: use letters, digits, _ and -");
  if (!shown.recipe) return Failure("the spec has errors");
  diag::Findings findings;
  const Presets presets = PresetsOf(shown);
  if (!presets.Save(request.name, request.settings, findings)) return Failure(findings[0].message);
  return JsonReply([&](diag::Json& json) {
    json.Member("file", diag::SafeText(presets.FileOf(request.name).string()));
    json.Member("presets", presets.List());
  });
}

Reply Studio::State::LoadPreset(const Request& request) {
  Request bare = request;
  bare.settings.clear();
  const ShownVariant& shown = cache.LoadSpec(bare);
  if (!shown.recipe || !Presets::IsValidName(request.name))
    return Failure("there is no such preset");
  const spec::LoadOptions load = {.parameter_files = {PresetsOf(shown).FileOf(request.name)},
                                  .search_path = start.load.search_path};
  diag::Sources sources;
  diag::Findings findings;
  const auto recipe = forge::LoadRecipe(start.reference, load, sources, findings);
  return JsonReply([&](diag::Json& json) {
    WriteSettings(json, recipe);
    WriteFindings(json, findings, sources);
  });
}

std::optional<picture::Image> Studio::State::DrawPicture(const Request& request,
                                                         ShownVariant& shown,
                                                         diag::Findings& findings) {
  if (shown.subject == nullptr) return std::nullopt;
  if (renderer == nullptr) renderer = picture::Renderer::Open(findings);
  if (renderer == nullptr) return std::nullopt;
  MoveJoints(request, shown);
  return renderer->Draw(*shown.subject, request.picture, findings);
}

// Draws nine variants from the request's index on, in three rows of three. Sets `texts` to a text
// for each variant: the reason why it has no picture, or an empty text if it has one. Draws the
// variant of the request's index last, because the cache keeps the last variant. Returns nullopt if
// there is no renderer.
std::optional<picture::Image> Studio::State::DrawNine(const Request& request,
                                                      std::vector<std::string>& texts) {
  texts.assign(9, "");
  picture::Image image{request.picture.width, request.picture.height, {}};
  image.rgba.assign(4 * static_cast<std::size_t>(image.width * image.height), 255);
  Request one = request;
  one.picture.width /= 3;
  one.picture.height /= 3;
  for (int cell = 8; cell >= 0; --cell) {
    one.index = request.index + static_cast<std::uint64_t>(cell);
    ShownVariant& shown = cache.Make(one, Validation::kNone);
    diag::Findings findings;
    const auto tile = DrawPicture(one, shown, findings);
    if (findings.HasErrors() && renderer == nullptr) return std::nullopt;
    findings.Append(shown.Findings());
    if (tile)
      PutInCell(*tile, cell, image);
    else
      texts[static_cast<std::size_t>(cell)] = FailureText(one.index, findings);
  }
  return image;
}

Reply Studio::State::Draw(const Request& request) {
  std::optional<picture::Image> nine;
  std::vector<std::string> cells;
  if (request.nine) nine = DrawNine(request, cells);
  const Validation level = request.picture.quick ? Validation::kNone : Validation::kLoad;
  ShownVariant& shown = cache.Make(request, level);
  diag::Findings findings = shown.Findings();
  const std::optional<picture::Image> image =
      nine ? std::move(nine) : DrawPicture(request, shown, findings);
  Reply reply = JsonReply([&](diag::Json& json) {
    WriteVariant(json, shown);
    json.Member("cells", cells);
    WriteFindings(json, findings, shown.sources);
  });
  if (image)
    reply.picture = request.picture.quick ? picture::EncodeWebpFast(*image, kQuickQuality)
                                          : picture::EncodeWebp(*image, kQuality);
  reply.files = cache.Files();
  return reply;
}

// Returns all findings about a variant, including those of the physics checks.
Reply Studio::State::Check(const Request& request) {
  const ShownVariant& shown = cache.Make(request, Validation::kPhysics);
  return JsonReply([&](diag::Json& json) { WriteFindings(json, shown.Findings(), shown.sources); });
}

// Returns an animation of the simulated drop or, if the request has a name, of the drive of the
// joint with this name.
Reply Studio::State::Film(const Request& request) {
  ShownVariant& shown = cache.Make(request, Validation::kNone);
  if (shown.subject == nullptr) return Failure("the variant has errors");
  diag::Findings findings;
  if (renderer == nullptr) renderer = picture::Renderer::Open(findings);
  const forge::Variant& variant = *shown.variant;
  const std::optional<physics::Film> film =
      renderer == nullptr ? std::nullopt
                          : laboratory.Record(variant.document, *variant.object, request.name,
                                              kMostFrames, findings);
  const auto frames =
      film && !film->positions.empty()
          ? renderer->DrawFilm(*shown.subject, film->positions, request.picture, findings)
          : std::nullopt;
  if (!frames) return Failure(findings.empty() ? "it cannot be simulated" : findings[0].message);
  const auto count = static_cast<double>(frames->size());
  const int delay = std::max(kShortestFrame, static_cast<int>(1000 * film->time / count));
  Reply reply = JsonReply([&](diag::Json& json) {
    json.Member("text", FilmText(request.name, film->time, delay * count / 1000));
  });
  reply.picture = picture::EncodeWebpFilm(*frames, delay, kQuickQuality);
  return reply;
}

Reply Studio::State::Redraw(Request request) {
  std::erase_if(request.settings,
                [&](const spec::Setting& setting) { return setting.name == request.name; });
  const ShownVariant& shown = cache.Make(request, Validation::kNone);
  return JsonReply([&](diag::Json& json) {
    if (shown.variant) {
      for (const auto& [name, value] : shown.variant->record.params) {
        if (name == request.name) json.Member("value", value);
      }
    }
    WriteFindings(json, shown.Findings(), shown.sources);
  });
}

Reply Studio::State::Export(const Request& request) {
  ShownVariant& shown = cache.Make(request, Validation::kLoad);
  const VariantKey variant{request.seed, request.index, start.place_seed};
  std::string text;
  std::string picture;
  diag::Findings findings;
  if (request.name == "command" && request.count > 1 && !shown.recipe)
    return Failure("the spec or a value has errors");
  if (request.name == "command") {
    text = CommandText(start.reference, request.settings, variant, request.count,
                       shown.recipe ? shown.recipe->spec->name : "");
  } else if (request.name == "seed") {
    text = OptionsText(variant);
  } else if (request.name == "params") {
    text = ParamsText(request.settings);
  } else if (!shown.variant || shown.variant->object == nullptr) {
    return Failure("the variant has errors");
  } else if (request.name == "mjcf") {
    const mjcf::MjcfDocument& document = shown.variant->document;
    if (document.assets.empty())
      text = document.text;
    else if (!ArchiveMjcf(shown.recipe->spec->name, document, picture, findings))
      return Failure(findings[0].message);
  } else if (request.name == "png") {
    const std::optional<picture::Image> image = DrawPicture(request, shown, findings);
    if (!image) return Failure("it cannot be drawn");
    picture = picture::EncodePng(*image, {{"Software", fmt::format("mjforge {}", forge::Version())},
                                          {"mjforge", FactsText(start.reference, variant)}});
  } else {
    return Failure("there is no export '" + request.name + "'");
  }
  Reply reply = JsonReply([&](diag::Json& json) {
    json.Member("text", text);
    json.Member("file", shown.recipe ? shown.recipe->spec->name : "");
  });
  reply.picture = std::move(picture);
  return reply;
}

Reply Studio::State::Pick(const Request& request) {
  ShownVariant& shown = cache.Make(request, Validation::kNone);
  return JsonReply([&](diag::Json& json) {
    if (shown.subject == nullptr) return;
    MoveJoints(request, shown);
    WritePart(json, shown, picture::GeomAt(*shown.subject, request.picture, request.x, request.y));
  });
}

// Returns the text of a file from which the spec was read. The page cannot read other files.
Reply Studio::State::Source(const Request& request) {
  const ShownVariant& shown = cache.LoadSpec(request);
  for (std::uint32_t i = 1; i <= shown.sources.size(); ++i) {
    if (shown.sources.Name(i) != request.name) continue;
    return JsonReply(
        [&](diag::Json& json) { json.Member("text", diag::SafeLines(shown.sources.Text(i))); });
  }
  return Failure("the spec was not read from '" + request.name + "'");
}

}  // namespace mjforge::customize
