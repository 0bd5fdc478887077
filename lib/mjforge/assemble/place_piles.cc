// Bodies with `pile:`, which fall onto a region: random poses at their release, and MuJoCo options
// that let piles come to rest.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/placements.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Adds the options with which a pile comes to rest in MuJoCo, unless the spec sets them itself.
// With a pyramidal cone and impratio 1, bodies slide on each other forever. Without noslip
// iterations, they creep by some millimetres per second. Without multiccd, which is the default
// only from MuJoCo 3.8 on, a convex piece may rest on a single contact point.
void AddOptions(std::vector<model::Section>& sections) {
  std::vector<model::Element>& options = model::ElementsOf(*spec::FindSection("option"), sections);
  if (options.empty()) options.emplace_back().tag = "option";
  model::Element& option = options.front();
  AddUnlessPresent({.name = "cone", .text = "elliptic"}, option.attributes);
  AddUnlessPresent({.name = "impratio", .numbers = {10}}, option.attributes);
  AddUnlessPresent({.name = "noslip_iterations", .numbers = {20}}, option.attributes);
  auto flag = std::ranges::find(option.children, "flag", &model::Element::tag);
  if (flag == option.children.end()) {
    flag = option.children.emplace(option.children.end());
    flag->tag = "flag";
  }
  AddUnlessPresent({.name = "multiccd", .text = "enable"}, flag->attributes);
}

}  // namespace

void Placements::ReadPile(const Request& request, sample::StreamId path, model::Pile& pile) {
  FieldReader reader(scope_.values, context_.findings, "body", request.name, path);
  for (const spec::Field& field : *request.entry.place->pile) {
    if (field.info->id == Key::kOrder) pile.is_big_first = reader.Word(field) != "listed";
    if (field.info->id == Key::kTime) pile.time = reader.Number(field).value_or(pile.time);
  }
}

void Placements::CheckPile(const Request& request, const model::Pile& pile,
                           sample::StreamId places) {
  if (pile.mark == request.entry.place->mark) return;  // the pile has the options of this entry
  model::Pile asked;
  asked.is_big_first = pile.is_big_first;
  asked.time = pile.time;
  ReadPile(request, places, asked);
  if (asked.is_big_first == pile.is_big_first && asked.time == pile.time) return;
  context_.findings
      .Add(Code::kModelBadPlace, request.entry.place->mark,
           fmt::format("the pile in {} has another `{}` here than where it begins", Quoted(pile.at),
                       asked.time == pile.time ? "order" : "time"),
           "give it to the first entry of the pile")
      .notes.push_back({pile.mark, "the pile begins here"});
}

void Placements::PileUp(const Request& request, sample::StreamId places) {
  FieldReader reader(scope_.values, context_.findings, "body", request.name, places);
  Trial trial;
  if (!ReadTarget(request, reader, trial)) return;
  const diag::SourceMark mark = request.entry.place->Find(Key::kAt)->value.mark;
  if (trial.target.region == nullptr) {
    context_.findings.Add(Code::kModelBadPlace, mark,
                          fmt::format("body {} cannot be piled up at {}, which is a site",
                                      Quoted(request.name), Quoted(trial.at)),
                          "a pile needs a region: give the body one with `regions:`");
    return;
  }
  if (!CheckRegionIsLevel(request, trial, mark)) return;
  model::Pile& pile = PileAt(request, trial, places);
  sample::Numbers q;
  scope_.values.AppendRotation(sample::Child(places, "turn"), q);
  model::Pile::Item& item = pile.items.emplace_back();
  item.body = request.body;
  item.q = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  item.uv = DrawPosition(pile.region.type != model::RegionType::kBox, places);
  model::Body& body = context_.object.bodies[static_cast<std::size_t>(request.body)];
  body.parent = trial.where.support;
  body.X_PB = pile.region.X_BR;
  body.place_name = names_.OutermostName(trial.at);
}

model::Pile& Placements::PileAt(const Request& request, const Trial& trial,
                                sample::StreamId places) {
  std::vector<model::Pile>& piles = context_.object.piles;
  const auto pile = std::ranges::find_if(piles, [&](const model::Pile& other) {
    return other.support == trial.where.support && other.region.site == trial.target.region->site;
  });
  if (pile != piles.end()) {
    CheckPile(request, *pile, places);
    return *pile;
  }
  model::Pile& added = piles.emplace_back();
  added.at = trial.at;
  added.support = trial.where.support;
  added.region = *trial.target.region;
  added.mark = request.entry.place->mark;
  ReadPile(request, places, added);
  AddOptions(context_.object.sections);
  return added;
}

bool Placements::IsPiled(const Request& request, int body, diag::SourceMark mark) {
  for (const model::Pile& pile : context_.object.piles) {
    if (std::ranges::find(pile.items, body, &model::Pile::Item::body) == pile.items.end()) continue;
    context_.findings.Add(Code::kModelBadPlace, mark,
                          fmt::format("body {} is placed by {}, which has no place before the pile "
                                      "has come to rest",
                                      Quoted(request.name), Quoted(names_.NameOf(body))),
                          "place it at a body that is not in a pile");
    return true;
  }
  return false;
}

}  // namespace mjforge::assemble
