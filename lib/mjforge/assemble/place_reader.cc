// Reads `place:` for one attempt to place a body: draws position, yaw and stable pose, and checks
// that the bodies to which `place:` refers already have places.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/placements.h"
#include "mjforge/assemble/regions.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

bool IsDrawn(const std::vector<spec::Field>& fields) {
  return std::ranges::any_of(fields,
                             [](const spec::Field& field) { return spec::HasDraw(field.value); });
}

// Returns the body's entry with this literal name; null if there is none.
const spec::BodyEntry* FindEntry(const spec::ObjectSpec& spec, std::string_view name) {
  return diag::FindIf(spec.bodies, [&](const spec::BodyEntry& entry) {
    return spec::LiteralText(entry.head.name) == name;
  });
}

// Returns a key of `place:` or `beside:` that has no meaning if the place is a site; null if there
// is none.
const spec::Field* WithoutMeaningAtSites(const spec::PlaceEntry& place) {
  constexpr Key kOfSites[] = {Key::kAt, Key::kBy, Key::kYaw, Key::kClear};
  if (!place.beside.empty()) return &place.beside.front();
  return diag::FindIf(place.fields, [&](const spec::Field& field) {
    return std::ranges::find(kOfSites, field.info->id) == std::end(kOfSites);
  });
}

// Returns the pose that a uniform random number `u` in (0, 1) selects according to the
// probabilities of the poses.
const model::StablePose& DrawPose(const std::vector<model::StablePose>& poses, double u) {
  for (const model::StablePose& pose : poses) {
    u -= pose.probability;
    if (u < 0) return pose;
  }
  return poses.back();
}

std::string OwnerOf(std::string_view name) { return fmt::format("body {}", Quoted(name)); }

// Returns a verb for messages about two bodies: the relation that a key of `place:` or `beside:`
// states.
std::string_view RelationOf(Key key) {
  return key == Key::kFacing ? "faces" : key == Key::kBody ? "is placed beside" : "is placed at";
}

}  // namespace

std::optional<Placements::Trial> Placements::Draw(const Request& request, sample::StreamId path) {
  const spec::PlaceEntry& place = *request.entry.place;
  FieldReader reader(scope_.values, context_.findings, "body", request.name, path);
  Trial trial;
  if (!ReadTarget(request, reader, trial)) return std::nullopt;
  trial.is_drawn = IsDrawn(place.fields) || IsDrawn(place.beside);
  if (!reader.ReadOptional(place, Key::kClear, &FieldReader::Number, trial.where.clear))
    return std::nullopt;
  const bool by_sites = trial.target.region == nullptr || place.Find(Key::kBy) != nullptr;
  const bool good = by_sites
                        ? ReadSites(request, reader, trial)
                        : CheckRegionIsLevel(request, trial, place.Find(Key::kAt)->value.mark) &&
                              ReadArea(request, reader, path, trial);
  return good ? std::optional(std::move(trial)) : std::nullopt;
}

bool Placements::ReadTarget(const Request& request, FieldReader& reader, Trial& trial) {
  const spec::Field& at = *request.entry.place->Find(Key::kAt);
  const std::optional<std::string> name = reader.Text(at);
  if (!name) return false;
  trial.at = *name;
  const std::optional<PlaceTarget> target = names_.Find(*name);
  if (!target) {
    names_.ReportTarget(OwnerOf(request.name), *name, at.value.mark, context_.findings);
    return false;
  }
  trial.target = *target;
  trial.where.support = target->body;
  trial.where.front = BodyAt(request.body).front;
  return CheckPlaced(request, target->body, at);
}

bool Placements::ReadSites(const Request& request, FieldReader& reader, Trial& trial) {
  const spec::PlaceEntry& place = *request.entry.place;
  if (const spec::Field* field = WithoutMeaningAtSites(place))
    return reader.Report(Code::kModelBadPlace, *field,
                         "has no meaning at a site, which decides the pose");
  if (!reader.ReadOptional(place, Key::kYaw, &FieldReader::Number, trial.where.yaw)) return false;
  trial.where.X_SupportSite = trial.target.X_BT();
  const spec::Field* by = place.Find(Key::kBy);
  if (by == nullptr) return true;
  const std::optional<std::string> name = reader.Text(*by);
  if (!name) return false;
  const std::string full = fmt::format("{}.{}", request.name, *name);
  const std::optional<PlaceTarget> own = names_.Find(full);
  if (!own) {
    names_.ReportTarget(OwnerOf(request.name), full, by->value.mark, context_.findings, "sites");
    return false;
  }
  trial.where.X_BodySite = X_WB(request.body).Inverse() * X_WB(own->body) * own->X_BT();
  return true;
}

bool Placements::ReadArea(const Request& request, FieldReader& reader, sample::StreamId path,
                          Trial& trial) {
  const spec::PlaceEntry& place = *request.entry.place;
  model::PlaceTry& where = trial.where;
  where.region = trial.target.region;
  if (!reader.ReadOptional(place, Key::kOverhang, &FieldReader::Number, where.overhang) ||
      !reader.ReadOptional(place, Key::kYaw, &FieldReader::Number, where.yaw))
    return false;
  if (place.Find(Key::kYaw) == nullptr && place.beside.empty() &&
      place.Find(Key::kFacing) == nullptr) {
    where.yaw = 2 * std::numbers::pi * scope_.values.Uniforms(sample::Child(path, "yaw"))[0];
    trial.is_drawn = true;
  }
  return ReadPosition(request, reader, path, trial) && ReadFacing(request, reader, where) &&
         ReadLying(request, reader, path, trial);
}

bool Placements::ReadPosition(const Request& request, FieldReader& reader, sample::StreamId path,
                              Trial& trial) {
  const spec::PlaceEntry& place = *request.entry.place;
  model::PlaceTry& where = trial.where;
  const bool is_disc = where.region->type == model::RegionType::kDisc;
  if (!place.beside.empty() && !ReadBeside(request, path, trial)) return false;
  if (const spec::Field* uv = place.Find(Key::kUv)) {
    const auto position = reader.Vector<2>(*uv);
    if (!position) return false;
    where.uv = *position;
    constexpr double kRounding = 1e-9;
    if (!is_disc || where.beside || where.uv.norm() <= 1 + kRounding) return true;
    return reader.Report(Code::kModelBadValue, *uv,
                         fmt::format("is {} from the centre of a disc; it must be at most 1",
                                     expr::NumberText(where.uv.norm())),
                         "in polar form: [r * cos(a), r * sin(a)]");
  }
  if (where.beside) return true;
  trial.is_drawn = true;
  where.uv = DrawPosition(is_disc, path);
  return true;
}

Eigen::Vector2d Placements::DrawPosition(bool in_disc, sample::StreamId path) const {
  const std::array<double, 4> u = scope_.values.Uniforms(sample::Child(path, "uv"));
  if (!in_disc) return {2 * u[0] - 1, 2 * u[1] - 1};
  const double angle = 2 * std::numbers::pi * u[1];
  return std::sqrt(u[0]) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

bool Placements::ReadBeside(const Request& request, sample::StreamId path, Trial& trial) {
  const spec::PlaceEntry& place = *request.entry.place;
  FieldReader reader(scope_.values, context_.findings, "body", request.name,
                     sample::Child(path, "beside"));
  model::Beside beside;
  const std::optional<int> body = ReadBody(request, reader, *place.FindBeside(Key::kBody));
  const std::optional<std::string> side = reader.Word(*place.FindBeside(Key::kSide));
  if (!body || !side) return false;
  beside.body = *body;
  beside.front = BodyAt(*body).front;
  const std::vector<std::string_view> sides =
      expr::WordsOf(spec::kBesideElement.Find(Key::kSide)->words);  // in the order of model::Side
  beside.side = static_cast<model::Side>(std::ranges::find(sides, *side) - sides.begin());
  if (const spec::Field* gap = place.FindBeside(Key::kGap)) {
    const std::optional<double> distance = reader.Number(*gap);
    if (!distance) return false;
    beside.gap = *distance;
  }
  trial.where.beside = beside;
  return true;
}

bool Placements::ReadFacing(const Request& request, FieldReader& reader, model::PlaceTry& where) {
  const spec::Field* facing = request.entry.place->Find(Key::kFacing);
  if (facing == nullptr) return true;
  if (facing->value.type == expr::Type::kText) {
    const std::optional<int> body = ReadBody(request, reader, *facing);
    if (body) where.facing = X_WB(*body).p.head<2>();
    return body.has_value();
  }
  if (facing->value.components == 2) {
    const auto point = reader.Vector<2>(*facing);
    if (!point) return false;
    const model::Pose X_WS = X_WB(scope_.body) * scope_.X_BS;
    where.facing = (X_WS * Eigen::Vector3d((*point)[0], (*point)[1], 0)).head<2>();
    return true;
  }
  const auto direction = reader.Vector<3>(*facing);
  if (!direction) return false;
  where.direction = (X_WB(scope_.body).q * (scope_.X_BS.q * *direction)).head<2>();
  if (!where.direction->isZero(1e-12)) return true;
  return reader.Report(Code::kModelBadRotation, *facing, "has no horizontal direction");
}

bool Placements::ReadLying(const Request& request, FieldReader& reader, sample::StreamId path,
                           Trial& trial) {
  const spec::Field* field = request.entry.place->Find(Key::kLying);
  if (field == nullptr) return true;
  const std::optional<std::string> name = reader.Text(*field);
  if (!name) return false;
  if (*name == "upright") return true;
  const std::vector<model::StablePose>& poses = StablePosesOf(request);
  if (*name == "any" && !poses.empty()) {
    const double u = scope_.values.Uniforms(sample::Child(path, "lying"))[0];
    trial.where.lying = DrawPose(poses, u).rotation;
    trial.is_drawn = true;
    return true;
  }
  const auto found = std::ranges::find(poses, *name, &model::StablePose::name);
  if (found != poses.end()) {
    trial.where.lying = found->rotation;
    return true;
  }
  std::vector<std::string_view> names = {"any"};
  std::ranges::transform(poses, std::back_inserter(names), &model::StablePose::name);
  const std::string hint = diag::DidYouMean(*name, std::span<const std::string_view>(names));
  return reader.Report(
      Code::kModelBadPlace, *field,
      fmt::format("is {}, in which the body is not stable", Quoted(*name)),
      hint.empty() ? fmt::format("stable ways: {}", fmt::join(names, ", ")) : hint);
}

const std::vector<model::StablePose>& Placements::StablePosesOf(const Request& request) {
  if (posed_body_ != request.body)
    stable_poses_ = context_.placer.StablePoses(request.body, BodyAt(request.body).front);
  posed_body_ = request.body;
  return stable_poses_;
}

std::optional<int> Placements::ReadBody(const Request& request, FieldReader& reader,
                                        const spec::Field& field) {
  const std::optional<std::string> name = reader.Text(field);
  if (!name) return std::nullopt;
  const std::optional<int> body = names_.FindBody(*name);
  if (!body) names_.ReportBody(OwnerOf(request.name), *name, field.value.mark, context_.findings);
  return body && CheckPlaced(request, *body, field) ? body : std::nullopt;
}

bool Placements::CheckPlaced(const Request& request, int body, const spec::Field& field) {
  const diag::SourceMark mark = field.value.mark;
  if (IsPiled(request, body, mark)) return false;
  // Finds `top`, the topmost body at or above `body`: the spec's root, a child of the root, or a
  // body without a parent, which has no place yet.
  int top = body;
  while (top != scope_.body && BodyAt(top).parent >= 0 && BodyAt(top).parent != scope_.body)
    top = BodyAt(top).parent;
  const bool stands = top == scope_.body || BodyAt(top).parent == scope_.body;
  if (stands && body < request.body) return true;
  if (top < request.body) {  // no place was found for `top`, and this was reported
    if (context_.left_out.contains(BodyAt(top).name)) LeaveOut(request);
    return false;
  }
  const std::string name = names_.NameOf(stands ? body : top);
  const bool is_itself = top == request.body && field.info->id != Key::kAt;
  const std::string circle = is_itself ? std::string() : CircleOf(request.name);
  const bool is_same_entry = BodyAt(top).mark == request.entry.head.mark;
  std::string hint;
  if (is_same_entry && top != request.body) {
    hint = "bodies of one entry find their places in the order of `for`: name an earlier one";
  } else if (circle.empty() && top != request.body) {
    hint =
        fmt::format("write the entry of {} before that of {}", Quoted(name), Quoted(request.name));
  }
  diag::Finding& finding = context_.findings.Add(
      Code::kModelBadPlace, mark,
      !circle.empty() ? fmt::format("the places of bodies form a circle: {}", circle)
      : top == request.body
          ? fmt::format("body {} {} itself", Quoted(request.name), RelationOf(field.info->id))
          : fmt::format("body {} is placed before {}", Quoted(request.name), Quoted(name)),
      std::move(hint));
  if (!is_same_entry)
    finding.notes.push_back({BodyAt(top).mark, fmt::format("{} is here", Quoted(name))});
  return false;
}

bool Placements::CheckRegionIsLevel(const Request& request, const Trial& trial,
                                    diag::SourceMark mark) {
  const double tilt = model::TiltOf(X_WB(trial.target.body) * trial.target.region->X_BR);
  if (tilt <= kLevelAngle) return true;
  context_.findings
      .Add(Code::kModelNotLevel, mark,
           fmt::format("body {} cannot stand at {}, which is {}", Quoted(request.name),
                       Quoted(trial.at), TiltText(tilt)))
      .notes.push_back({trial.target.mark(), "the place is described here"});
  return false;
}

std::string Placements::CircleOf(const std::string& name) const {
  // Follows the names in `at` and `beside`, and notes from which body each body was reached first.
  std::map<std::string, std::string> reached_from;
  std::vector<std::string> open = {name};
  while (!open.empty() && !reached_from.contains(name)) {
    const std::string from = std::move(open.back());
    open.pop_back();
    for (std::string& next : NamesInPlaceOf(from)) {
      if (reached_from.emplace(next, from).second) open.push_back(std::move(next));
    }
  }
  if (!reached_from.contains(name)) return {};
  std::string circle = name;
  std::string at = name;
  do {
    at = reached_from.at(at);
    circle.insert(0, at + " -> ");
  } while (at != name);
  return circle;
}

std::vector<std::string> Placements::NamesInPlaceOf(std::string_view name) const {
  std::vector<std::string> names;
  const spec::BodyEntry* entry = FindEntry(scope_.values.spec(), name);
  if (entry == nullptr || !entry->place) return names;
  for (const spec::Field* field :
       {entry->place->Find(Key::kAt), entry->place->FindBeside(Key::kBody)}) {
    const auto other = field == nullptr ? std::nullopt : spec::LiteralText(field->value);
    if (other) names.emplace_back(other->substr(0, other->find('.')));
  }
  return names;
}

}  // namespace mjforge::assemble
