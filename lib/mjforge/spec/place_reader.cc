// Reader of `place:`, the place of a body on, in or beside other bodies.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Keys of a body that must not occur together with `place:`, which determines the pose and parent.
constexpr std::string_view kOtherPlaces[] = {"parent",    "pos",    "quat", "euler",
                                             "axisangle", "xyaxes", "zaxis"};
// Keys of a place that must not occur together with `by`, because the two sites `at` and `by`
// determine the pose.
constexpr std::string_view kNotWithSites[] = {"uv", "beside", "facing", "lying", "overhang"};

// Keys of a place that must not occur together with `pile`, because a simulation determines the
// pose.
constexpr std::string_view kNotInPiles[] = {"uv",     "by",    "beside", "yaw",
                                            "facing", "lying", "clear",  "overhang"};

// Reads `facing`: the name of a body, a point (2 numbers), or a direction (3 numbers).
void ReadFacing(const YamlNode::Pair& pair, std::vector<Field>& fields, Context& context) {
  const bool is_name = pair.value.kind == YamlNode::Kind::kScalar;
  Value value =
      is_name ? context.values.ReadText(pair.value) : context.values.ReadAnything(pair.value);
  if (value.components == 0) return;  // already reported
  const bool is_vector = value.type == expr::Type::kNumber && !value.is_list &&
                         (value.components == 2 || value.components == 3);
  if (value.type != expr::Type::kText && !is_vector) {
    context.findings.Add(Code::kSpecWrongType, value.mark,
                         fmt::format("'facing' is {}, not the name of a body, a point [x, y] or a "
                                     "direction [x, y, 0]",
                                     KindText(value)));
    return;
  }
  if (value.components == 2) {
    static constexpr FieldInfo kPoint = {
        .key = "facing", .min_count = 2, .max_count = 2, .unit = "m"};
    context.values.CheckUnits(kPoint, value);
  }
  fields.emplace_back(kPlaceElement.Find(Key::kFacing), std::move(value), pair.mark);
}

}  // namespace

std::optional<PlaceEntry> ReadPlace(const YamlNode& body, Context& context) {
  CheckNeeds("fewer", "place", body, context);
  const YamlNode* map = body.Find("place");
  if (map == nullptr || !IsMap(*map, "where the body stands", context)) return std::nullopt;
  RejectBeside("place", kOtherPlaces, body, "'place' decides where the body is", context);
  PlaceEntry place;
  place.mark = map->mark;
  place.fields = ReadElementFields(kPlaceElement, *map, context);
  if (const YamlNode::Pair* facing = map->FindPair("facing"))
    ReadFacing(*facing, place.fields, context);
  if (map->Find("by") != nullptr)
    RejectBeside("by", kNotWithSites, *map, "the two sites decide the place", context);
  const YamlNode* beside = map->Find("beside");
  if (beside != nullptr && IsMap(*beside, "a body and its side", context)) {
    place.beside = ReadElementFields(kBesideElement, *beside, context);
  }
  const YamlNode* pile = map->Find("pile");
  if (pile == nullptr || !IsMap(*pile, "how a pile is made", context)) return place;
  RejectBeside("pile", kNotInPiles, *map, "the simulation decides how the body lies", context);
  if (const YamlNode::Pair* fewer = body.FindPair("fewer")) {
    context.findings.Add(Code::kSpecConflict, fewer->mark,
                         "'fewer' together with 'pile': a pile has room for every body");
  }
  place.pile = ReadElementFields(kPileElement, *pile, context);
  const YamlNode* joints = body.Find("joints");
  if (joints == nullptr || joints->text != "free") {
    context.findings.Add(Code::kSpecConflict, map->FindPair("pile")->mark,
                         "'pile' without 'joints: free': the body cannot fall");
  }
  return place;
}

}  // namespace mjforge::spec
