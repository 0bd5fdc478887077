// Rows of the field table: the keys of each element of a spec, with kind, unit, bounds and meaning.

#include "mjforge/spec/fields.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "mjforge/diag/diag.h"

namespace mjforge::spec {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Structures that several fields take, or whose schema is long.
namespace structures {
constexpr Structure kFunctions = {
    "name(arguments): expression",
    R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]* *\\(.*\\)$": )"
    R"({"anyOf": [{"type": "number"}, {"@expression"}]}}, "additionalProperties": false)"};
constexpr Structure kConditions = {"list of conditions",
                                   R"("anyOf": [{"@is condition"}, {"@list condition"}])"};
constexpr Structure kCondition = {"condition", R"("@is condition")"};
constexpr Structure kLoops = {"variable: count or list",
                              R"("type": "object", "additionalProperties": )"
                              R"({"anyOf": [{"@is number"}, {"@is list"}]})"};
constexpr Structure kImports = {
    "list of files",
    R"("anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}])"};
constexpr Structure kParts = {"list of parts", R"("@list part")"};
constexpr Structure kSites = {"list of sites", R"("@list site")"};
constexpr Structure kRegions = {"`auto`, or list of regions",
                                R"("anyOf": [{"const": "auto"}, {"@list region"}])"};
constexpr Structure kCameras = {"list of cameras", R"("@list camera")"};
constexpr Structure kLights = {"list of lights", R"("@list light")"};
constexpr Structure kOverrides = {
    "name: value",
    R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*)?$": )"
    R"({"@is value"}}, "additionalProperties": false)"};
constexpr Structure kFacing = {
    "name, or 2 or 3 numbers",
    R"("anyOf": [{"@is text"}, {"@list number", "minItems": 2, "maxItems": 3}, )"
    R"({"@is vector_draw"}])"};
constexpr Structure kPositions = {"joint: position", R"("@is positions")"};
constexpr Structure kStarts = {"joint: position, or list of starts",
                               R"("anyOf": [{"@is positions"}, {"@list start"}])"};
constexpr Structure kExcludes = {
    "list of pairs", R"("type": "array", "items": {"anyOf": [{"@pair"}, {"@is exclude"}]})"};
constexpr Structure kBodyPair = {"two names", R"("@pair")"};
constexpr Structure kExpectations = {
    "list of conditions and expectations",
    R"("type": "array", "items": {"anyOf": [{"@is condition"}, {"@is expectation"}]})"};
constexpr Structure kNames = {"name or list of names",
                              R"("anyOf": [{"type": "string"}, {"@list text", "minItems": 1}])"};
}  // namespace structures

// The text of a key, and the enumerator of the key if the code interprets it.
struct KeyName {
  std::string_view key;
  Key id = Key::kAttribute;
  constexpr KeyName(const char* text) : key(text) {}
  constexpr KeyName(const char* text, Key interpreted) : key(text), id(interpreted) {}
};

struct NumberBounds {
  double lower = -kInfinity;
  double upper = kInfinity;
  bool above = false;
};
constexpr NumberBounds kAnyNumber;
constexpr NumberBounds Above(double lower) { return {.lower = lower, .above = true}; }
constexpr NumberBounds AtLeast(double lower) { return {.lower = lower}; }
constexpr NumberBounds Between(double lower, double upper) { return {lower, upper}; }

struct CountRange {
  int min;
  int max;
};

// Functions that make a row of the table from key, kind, unit, bounds, default and meaning. An
// empty text means that there is no unit or no default.
constexpr FieldInfo Row(KeyName name, FieldKind kind, std::string_view default_text,
                        std::string_view doc) {
  return {.key = name.key, .id = name.id, .kind = kind, .default_text = default_text, .doc = doc};
}
constexpr FieldInfo Row(KeyName name, FieldKind kind, std::string_view doc) {
  return Row(name, kind, "", doc);
}
constexpr FieldInfo With(const Structure& structure, FieldInfo row) {
  row.kind = FieldKind::kStructure;
  row.structure = structure;
  return row;
}
constexpr FieldInfo Row(KeyName name, const Structure& structure, std::string_view doc) {
  return With(structure, Row(name, FieldKind::kStructure, doc));
}
constexpr FieldInfo Number(KeyName name, std::string_view unit, NumberBounds bounds,
                           std::string_view default_text, std::string_view doc) {
  FieldInfo row = Row(name, FieldKind::kNumber, default_text, doc);
  row.unit = unit;
  row.lower = bounds.lower;
  row.upper = bounds.upper;
  row.above = bounds.above;
  return row;
}
constexpr FieldInfo Integer(KeyName name, NumberBounds bounds, std::string_view default_text,
                            std::string_view doc) {
  FieldInfo row = Number(name, "", bounds, default_text, doc);
  row.kind = FieldKind::kInteger;
  return row;
}
constexpr FieldInfo Numbers(KeyName name, CountRange counts, std::string_view unit,
                            NumberBounds bounds, std::string_view default_text,
                            std::string_view doc) {
  FieldInfo row = Number(name, unit, bounds, default_text, doc);
  row.kind = FieldKind::kNumbers;
  row.min_count = counts.min;
  row.max_count = counts.max;
  return row;
}
constexpr FieldInfo Position(KeyName name, std::string_view default_text, std::string_view doc) {
  FieldInfo row = Numbers(name, {1, 4}, "rad or m", kAnyNumber, default_text, doc);
  row.kind = FieldKind::kPosition;
  return row;
}
constexpr FieldInfo Points(KeyName name, CountRange counts, std::string_view doc,
                           FieldKind kind = FieldKind::kPoints) {
  FieldInfo row = Numbers(name, counts, "m", kAnyNumber, "", doc);
  row.kind = kind;
  return row;
}
constexpr FieldInfo Word(KeyName name, std::string_view words, std::string_view default_text,
                         std::string_view doc, FieldKind kind = FieldKind::kWord) {
  FieldInfo row = Row(name, kind, default_text, doc);
  row.words = words;
  return row;
}
constexpr FieldInfo Required(FieldInfo row) {
  row.required = true;
  return row;
}
constexpr FieldInfo AnyUnit(FieldInfo row) {
  row.any_unit = true;
  return row;
}
constexpr FieldInfo On(Applies applies, FieldInfo row) {
  row.applies = applies;
  return row;
}
constexpr FieldInfo RefersTo(std::string_view kind, FieldInfo row) {
  row.refers = kind;
  return row;
}
constexpr FieldInfo Contact(const FieldInfo& row) { return On(Applies::kCollision, row); }

constexpr std::span<const FieldInfo, 1> RowsOf(const FieldInfo& row) {
  return std::span<const FieldInfo, 1>(&row, 1);
}
template <std::size_t count>
constexpr std::span<const FieldInfo, count> RowsOf(const std::array<FieldInfo, count>& rows) {
  return rows;
}

// Rows of the table for one element. An item of the list from which it is made is a row, or a group
// of rows that several elements share.
template <std::size_t count>
struct Table : std::array<FieldInfo, count> {
  template <typename... Items>
  constexpr Table(const Items&... items) {
    auto* end = this->data();
    (..., (end = std::ranges::copy(RowsOf(items), end).out));
  }
};
template <typename... Items>
Table(const Items&...) -> Table<(decltype(RowsOf(std::declval<Items>()))::extent + ...)>;

constexpr FieldInfo kObjectFields[] = {
    Required(Row("mjforge", {"1", R"("const": 1)"}, "Version of the format: 1.")),
    Required(Row({"name", Key::kName}, FieldKind::kPlainText,
                 "Name of the object and prefix of its elements' names: a letter, then letters, "
                 "digits and underscores.")),
    Row("description", FieldKind::kPlainText, "What the object is, for the catalogue."),
    Row("import", structures::kImports,
        "YAML files whose `materials`, `defaults`, `params` and `functions` may be used here; they "
        "are found like specs."),
    Row({"params", Key::kParams}, {"name: parameter", R"("@map parameter")"},
        "Parameters, drawn once per variant and visible to every expression, in any order."),
    Row("functions", structures::kFunctions,
        "Functions for every expression: `area(a, b): a * b`, of their arguments, the parameters "
        "and each other."),
    Row("require", structures::kConditions,
        "Conditions on the parameters; all parameters are redrawn until every condition holds."),
    Row({"materials", Key::kMaterials}, {"name: material", R"("@map material")"},
        "Named materials: how parts look and what they are made of."),
    Row("defaults", {"defaults", R"("@is defaults")"},
        "Values for the keys that parts, sites and joints leave out."),
    Row({"parts", Key::kParts}, structures::kParts, "The solid parts of the root body."),
    Row("sites", structures::kSites, "Sites of the root body."),
    Row("regions", structures::kRegions,
        "Places on the root body where other bodies can stand; `auto` finds them."),
    Row("cameras", structures::kCameras, "Cameras of the root body."),
    Row("lights", structures::kLights, "Lights of the root body."),
    Word("joints", "free none", "free",
         "Joints of the root body: `free` (one free joint named joint0), `none`, or a list.",
         FieldKind::kJoints),
    Row("bodies", {"list of bodies", R"("@list body")"},
        "Further bodies: parts, other specs and MJCF files, each with its joints."),
    Row("pose", structures::kStarts,
        "The start state: positions of joints by their names (m or rad, of a ball joint w, x, y, "
        "z), or a list with an entry for each joint or actuator."),
    Word({"start", Key::kStart}, "zero keyframe", "depends on the object and the target",
         "Where the file says how the object starts: in MuJoCo's zero configuration (qpos0), or in "
         "a keyframe."),
    Row("contact", {"contact", R"("@is contacts")"},
        "Pairs of bodies that do not collide with each other."),
    Row({"mjcf", Key::kMjcf}, FieldKind::kSections,
        "Any other MJCF section (sensor, actuator, tendon, equality, ...), element by element."),
    Number({"mass", Key::kMass}, "kg", Above(0), "",
           "Mass of the whole object; the parts are scaled to it."),
    Word({"placement", Key::kPlacement}, "center corner", "center",
         "`corner`: positions of parts and of the root's bodies are measured from the lower corner "
         "of the `total_size` box to the lower corner of each part or body."),
    Numbers({"total_size", Key::kTotalSize}, {3, 3}, "m", Above(0), "",
            "Half sizes of the declared bounding box, centred on the root body; used as the "
            "object's bounds in place of the computed ones."),
    Numbers({"front", Key::kFront}, {2, 2}, "any one", kAnyNumber, "0 -1",
            "Direction x, y of its front, for `beside` and `facing` of a `place`."),
    Row("expect", structures::kExpectations,
        "What must be true of every variant: conditions, and how bodies and parts lie."),
    Row("checks", {"checks", R"("@is checks")"},
        "Thresholds of the physical checks, and the findings to ignore."),
    Row("view", {"view", R"("@is view")"},
        "How pictures show the object: from where, and in which pose. The MJCF file does not "
        "depend on it."),
};

constexpr FieldInfo kParameterFields[] = {
    Row("value", FieldKind::kAnything, "The value, in any form."),
    Row({"doc", Key::kDoc}, FieldKind::kPlainText, "What the parameter means."),
    Row({"unit", Key::kUnit}, FieldKind::kPlainText,
        "Its unit: of SI (`m`, `kg/m^3`, `rad`), `1` for a plain number, `s, 1` for a vector. What "
        "the value is in where it names one; any other text is for readers only."),
    Row({"section", Key::kSection}, FieldKind::kPlainText,
        "Heading under which `customize` shows its control; parameters with the same heading are "
        "together."),
};

// Fields and groups of fields that several elements share.
constexpr FieldInfo kName =
    Row({"name", Key::kName}, FieldKind::kText,
        "Unique name: a letter, then letters, digits and underscores; `${...}` is filled in.");
constexpr Table kRepetition = {
    Row({"if", Key::kIf}, structures::kCondition,
        "The entry exists only where this condition holds."),
    Row({"for", Key::kFor}, structures::kLoops,
        "Repeats the entry: `{i: 8}` runs i from 0 to 7; several variables give all combinations, "
        "the last varying fastest."),
    Row("let", {"name: value", R"("@map value")"},
        "Values for this entry and what is in it, drawn or computed for each repetition; each may "
        "use those before it."),
};
constexpr Table kNamedEntry = {Required(kName), kRepetition};
constexpr FieldInfo kSubstitutes =
    Row({"materials", Key::kMaterials}, {"name: material's name", R"("@map text")"},
        "Materials of that spec, by name: the name of the one of this spec to use in its place.");
constexpr FieldInfo kPos =
    Numbers({"pos", Key::kPos}, {3, 3}, "m", kAnyNumber, "0 0 0", "Position.");
constexpr Table kOrientation = {
    Numbers(
        {"quat", Key::kQuat}, {4, 4}, "", kAnyNumber, "1 0 0 0",
        "Orientation as a quaternion w x y z (normalised for you), `random`, or `{about: axis}`."),
    Numbers({"euler", Key::kEuler}, {3, 3}, "rad", kAnyNumber, "",
            "Orientation as rotations about the moving x, y and z axes."),
    Numbers({"axisangle", Key::kAxisAngle}, {4, 4}, "any one, any one, any one, rad", kAnyNumber,
            "", "Orientation as an axis x y z and an angle."),
    Numbers({"xyaxes", Key::kXyAxes}, {6, 6}, "any one", kAnyNumber, "",
            "Orientation as the directions of the x and y axes."),
    Numbers({"zaxis", Key::kZAxis}, {3, 3}, "any one", kAnyNumber, "",
            "Orientation as the direction of the z axis, reached by the smallest rotation."),
};
constexpr Table kPose = {kPos, kOrientation};
constexpr FieldInfo kMaterialName = Row({"material", Key::kMaterial}, FieldKind::kText,
                                        "Name of a material of this spec or of an import.");
constexpr FieldInfo kRgba =
    On(Applies::kVisual, Numbers({"rgba", Key::kRgba}, {4, 4}, "", Between(0, 1), "",
                                 "Red, green, blue, opacity, or `{hsv: [h, s, v]}`."));
constexpr FieldInfo kUser =
    AnyUnit(Numbers("user", {1, 64}, "", kAnyNumber, "", "Numbers for the user's own code."));

constexpr FieldInfo kDensity =
    Number({"density", Key::kDensity}, "kg/m^3", AtLeast(0), "1000",
           "Density. Not together with `mass`. 0 only for what is only seen or only collides.");
constexpr Table kSurface = {
    Contact(Numbers("friction", {1, 3}, "1, m, m", AtLeast(0), "1 0.005 0.0001",
                    "Sliding, torsional and rolling friction.")),
    Contact(Numbers("solref", {1, 2}, "s, 1", kAnyNumber, "0.02 1",
                    "Contact solver: time constant and damping ratio.")),
    Contact(Numbers("solimp", {1, 5}, "1, 1, m, 1, 1", AtLeast(0), "0.9 0.95 0.001 0.5 2",
                    "Contact solver: impedance dmin, dmax, width, midpoint, power.")),
    Contact(
        Integer("condim", Between(1, 6), "3", "Dimensions of the contact space: 1, 3, 4 or 6.")),
};

constexpr Table kMaterialFields = {
    kRgba,
    Number("specular", "", Between(0, 1), "0.5", "Specular reflection of lights."),
    Number("shininess", "", Between(0, 1), "0.5", "How small highlights are."),
    Number("reflectance", "", Between(0, 1), "0", "Mirror reflection, for planes and boxes."),
    Number("emission", "", AtLeast(0), "0", "Glow, as a multiple of the colour."),
    Numbers("texrepeat", {1, 2}, "", Above(0), "1 1",
            "How often the texture repeats along its two axes."),
    Row("texuniform", FieldKind::kBoolean, "false",
        "Whether texrepeat counts per metre instead of per object."),
    Row("texture", {"texture", R"("@is texture")"},
        "A texture: `{builtin: checker, rgb1: ..., rgb2: ...}` or `{file: wood.png}`."),
    kDensity,
    kSurface,
    Row({"doc", Key::kDoc}, FieldKind::kPlainText,
        "What the material is, with the source of its numbers."),
};

constexpr FieldInfo kTextureFields[] = {
    Word("type", "2d cube", "cube", "`cube` wraps every shape; `2d` is for planes and meshes."),
    Word({"builtin", Key::kBuiltin}, "flat checker gradient", "", "A generated texture."),
    Row({"file", Key::kFile}, FieldKind::kText,
        "A PNG file, relative to the file that names it; copied to assets/."),
    Numbers("rgb1", {3, 3}, "", Between(0, 1), "0.8 0.8 0.8",
            "First colour of a generated texture."),
    Numbers("rgb2", {3, 3}, "", Between(0, 1), "0.5 0.5 0.5",
            "Second colour of a generated texture."),
    Word("mark", "none edge cross random", "none", "Marks drawn over a generated texture."),
    Numbers("markrgb", {3, 3}, "", Between(0, 1), "0 0 0", "Colour of the marks."),
    Number("random", "", Between(0, 1), "0.01", "Share of pixels that `mark: random` turns on."),
    Integer("width", Between(1, 4096), "64", "Pixels of a generated texture."),
    Integer("height", Between(1, 4096), "64",
            "Pixels of a generated texture; a cube's is its width."),
};

constexpr Table kPartFields = {
    kName,
    kRepetition,
    Word({"type", Key::kType}, "box sphere cylinder capsule ellipsoid prism lathe tube hull mesh",
         "", "The shape."),
    Numbers({"size", Key::kSize}, {1, 3}, "m", Above(0), "",
            "Half sizes as in MuJoCo: box x y z, sphere radius, cylinder and capsule radius and "
            "half length, ellipsoid three radii; with `fromto` only the radius (box, ellipsoid: "
            "the two across)."),
    kPose,
    Numbers({"fromto", Key::kFromTo}, {6, 6}, "m", kAnyNumber, "",
            "Two end points in place of a pose (capsule, cylinder, box, ellipsoid): the part's z "
            "axis points from the second to the first, turned the shortest way from +z."),
    Numbers({"up", Key::kUp}, {3, 3}, "any one", kAnyNumber, "",
            "Beside `fromto`: the direction that the part's y axis takes, as far as it can."),
    Points({"polygon", Key::kPolygon}, {2, 2}, "Corners x, y of a prism's outline."),
    Points({"holes", Key::kHoles}, {2, 2},
           "Holes through a prism or a box: outlines x, y of holes along z, each a list of points, "
           "and `{axis: x, outlines: [...]}` for holes along another axis.",
           FieldKind::kOutlines),
    Number({"height", Key::kHeight}, "m", Above(0), "",
           "Full height of a prism along z, centred on its position."),
    Number({"round", Key::kRound}, "m", Above(0), "",
           "Radius of the edges of a box, cylinder or hull, of the corners of a prism's polygon."),
    Number({"bevel", Key::kBevel}, "m", Above(0), "",
           "How far the edges at both ends of a prism are cut off, along and across."),
    Row({"round_collision", Key::kRoundCollision}, FieldKind::kBoolean, "true",
        "Whether what collides of a box or cylinder with `round` is rounded, too."),
    Points({"profile", Key::kProfile}, {2, 2},
           "Points r, z that are turned about the z axis of a lathe: a closed outline, or with "
           "`wall` an open line."),
    Number({"wall", Key::kWall}, "m", Above(0), "",
           "Thickness of a lathe's wall, from the profile towards the axis; of a tube's, which is "
           "hollow then to be seen and weighed."),
    Number({"angle", Key::kAngle}, "rad", NumberBounds{0, 2 * std::numbers::pi, true}, "360deg",
           "How far a lathe's profile is turned, counter-clockwise from the x axis."),
    Integer({"facets", Key::kFacets}, Between(3, 128), "16",
            "Sides of what collides for a whole turn; what is seen is smooth."),
    Points({"path", Key::kPath}, {3, 4},
           "Points x, y, z that a tube goes through; a fourth number is its radius there."),
    Number({"radius", Key::kRadius}, "m", Above(0), "", "Outer radius of a tube."),
    Number({"bend", Key::kBend}, "m", Above(0), "",
           "Radius of the arcs that take the place of the corners of a tube's path."),
    Row({"smooth", Key::kSmooth}, FieldKind::kBoolean, "false",
        "Whether a tube's path is a curve through its points."),
    Row({"closed", Key::kClosed}, FieldKind::kBoolean, "false",
        "Whether a tube goes on from its last point to its first."),
    Points({"points", Key::kPoints}, {3, 3}, "Points x, y, z whose convex hull a hull is."),
    Number({"crease", Key::kCrease}, "rad", Between(0, std::numbers::pi), "40deg",
           "Edges that turn by more are seen as sharp."),
    Row({"file", Key::kFile}, FieldKind::kText,
        "An OBJ or STL file for a mesh, relative to the spec."),
    Numbers({"scale", Key::kScale}, {1, 3}, "m or 1", kAnyNumber, "1",
            "Multiplies a mesh's coordinates (one number or x y z) or a prism's polygon (one "
            "number or x y)."),
    Word({"inertia", Key::kInertia}, "solid shell", "solid",
         "The mass of a mesh: in the solid that its closed surface encloses, or evenly on its "
         "surface, which may be open."),
    kDensity,
    Number({"mass", Key::kMass}, "kg", AtLeast(0), "",
           "Mass, in place of a density. 0 only for what is only seen or only collides."),
    kMaterialName,
    Word({"role", Key::kRole}, "both collision visual", "both",
         "`both` writes a collision geom NAME and a visual geom NAME_vis that has no contacts and "
         "no mass; `collision` only the first, `visual` only the second."),
    Word({"grain", Key::kGrain}, "x y z none", "",
         "Axis of a box, along which the grain of its material's texture runs: without it, that of "
         "the longest edge; x or y for a prism, a hull, and a box with holes. none: along y of its "
         "frame."),
    kRgba,
    On(Applies::kVisual, Integer({"group", Key::kGroup}, Between(0, 5), "",
                                 "Group of the visual geom in place of the target's.")),
    kSurface,
    Contact(Number("solmix", "", AtLeast(0), "1",
                   "Weight of this geom when contact parameters are mixed.")),
    Contact(Integer("priority", kAnyNumber, "0",
                    "The geom of higher priority sets the contact parameters.")),
    Contact(Number("margin", "m", AtLeast(0), "0", "Distance at which contacts appear.")),
    Contact(Number("gap", "m", AtLeast(0), "0",
                   "Part of the margin in which contacts exert no force.")),
    Contact(Integer("contype", Between(0, 2147483647), "1", "Collision bits of this geom.")),
    Contact(Integer("conaffinity", Between(0, 2147483647), "1",
                    "Collision bits that it collides with.")),
    Contact(Word("fluidshape", "none ellipsoid", "none", "Model of interaction with a fluid.")),
    Contact(Numbers("fluidcoef", {1, 5}, "", AtLeast(0), "0.5 0.25 1.5 1 1",
                    "Coefficients of the fluid interaction model.")),
    kUser,
    Row({"spec", Key::kSpec}, FieldKind::kPlainText,
        "Another spec whose parts are welded in at this pose; a path or a bundled spec's name."),
    Row({"params", Key::kParams}, structures::kOverrides, "Parameters set for the welded spec."),
    kSubstitutes,
    Row({"frame", Key::kFrame}, {"frame", R"("@is frame")"},
        "A rigid offset (pos and an orientation) for the `parts` of this entry."),
    Row({"parts", Key::kParts}, structures::kParts, "The parts that a frame moves."),
};

constexpr Table kSiteFields = {
    kNamedEntry,
    Word({"type", Key::kType}, "sphere capsule ellipsoid cylinder box", "sphere",
         "The shape that it is drawn as."),
    Numbers({"size", Key::kSize}, {1, 3}, "m", Above(0), "0.005", "Half sizes, as for parts."),
    kPose,
    kMaterialName,
    kRgba,
    Integer("group", Between(0, 5), "0", "Group that viewers show or hide together."),
    kUser,
};

constexpr Table kRegionFields = {
    kNamedEntry,
    Word({"type", Key::kType}, "box disc polygon auto", "box",
         "Its shape; `auto` finds level upper faces of the body's colliding parts: NAME, NAME_1, "
         "..., from the largest."),
    Numbers({"size", Key::kSize}, {1, 2}, "m", Above(0), "",
            "Half lengths x and y of a box; radius of a disc."),
    Points({"polygon", Key::kPolygon}, {2, 2}, "Corners x, y of a convex polygon."),
    Number({"area", Key::kArea}, "m^2", Above(0), "0.0025", "Least area that `auto` takes."),
    kPose,
    Number({"height", Key::kHeight}, "m", Above(0), "unlimited; for `auto` 3cm",
           "Free height above; for `auto` the least."),
    Number({"margin", Key::kMargin}, "m", AtLeast(0), "0",
           "How far from the edge everything stays that stands here."),
    Number({"clear", Key::kClear}, "m", AtLeast(0), "0",
           "Least distance between the things that stand here."),
    Row({"walls", Key::kWalls}, FieldKind::kBoolean, "false",
        "Whether it is an interior, into which things are lowered until they touch something."),
};

constexpr FieldInfo kMode = Word("mode", "fixed track trackcom targetbody targetbodycom",
                                 "targetbody where `target` is given, else fixed",
                                 "How it follows its body, or which body it looks at.");
constexpr FieldInfo kTarget =
    RefersTo("body", Row("target", FieldKind::kText, "The body that it looks at."));

constexpr Table kCameraFields = {
    kNamedEntry,
    Number("fovy", "rad", Between(0, std::numbers::pi), "45deg",
           "Angle that it sees from top to bottom; MJCF has it in degrees."),
    Number("ipd", "m", AtLeast(0), "0.068",
           "Distance between the eyes, for stereoscopic pictures."),
    kPose,
    kMode,
    kTarget,
    kUser,
};

constexpr Table kLightFields = {
    kNamedEntry,
    kPos,
    Numbers({"dir", Key::kAxis}, {3, 3}, "any one", kAnyNumber, "0 0 -1",
            "The direction of the light."),
    Row("directional", FieldKind::kBoolean, "false", "Whether it comes from far away."),
    Row("castshadow", FieldKind::kBoolean, "true", "Whether it throws shadows."),
    Row("active", FieldKind::kBoolean, "true", "Whether it is on."),
    Numbers("attenuation", {3, 3}, "1, 1/m, 1/m^2", AtLeast(0), "1 0 0",
            "Constant, linear and quadratic loss with distance."),
    Number("cutoff", "rad", Between(0, std::numbers::pi), "45deg",
           "Half angle of its cone; MJCF has it in degrees."),
    Number("exponent", "", AtLeast(0), "10", "How fast it fades towards the edge of the cone."),
    Numbers("ambient", {3, 3}, "", Between(0, 1), "0 0 0", "Colour of its ambient light."),
    Numbers("diffuse", {3, 3}, "", Between(0, 1), "0.7 0.7 0.7", "Colour of its diffuse light."),
    Numbers("specular", {3, 3}, "", Between(0, 1), "0.3 0.3 0.3", "Colour of its highlights."),
    kMode,
    kTarget,
};

constexpr Table kJointFields = {
    kNamedEntry,
    Word({"type", Key::kType}, "free ball slide hinge", "hinge", "The motion it allows."),
    Numbers({"pos", Key::kPos}, {3, 3}, "m", kAnyNumber, "0 0 0", "Position in the body."),
    Numbers({"axis", Key::kAxis}, {3, 3}, "any one", kAnyNumber, "0 0 1",
            "Axis of a hinge or slide in the body (normalised for you)."),
    Numbers({"range", Key::kRange}, {2, 2}, "rad or m", kAnyNumber, "",
            "Limits; they apply unless `limited: false`."),
    Row({"limited", Key::kLimited}, FieldKind::kBoolean, "true where `range` is given",
        "Whether the range applies."),
    Integer("group", Between(0, 5), "0", "Group that viewers show or hide together."),
    Number("stiffness", "Nm/rad or N/m", AtLeast(0), "0", "Spring towards springref."),
    Number("damping", "Nms/rad or Ns/m", AtLeast(0), "0",
           "Damping: force per speed, against the motion."),
    Numbers("springdamper", {2, 2}, "s, 1", AtLeast(0), "0 0",
            "Time constant and damping ratio, from which MuJoCo sets stiffness and damping."),
    Number("frictionloss", "Nm or N", AtLeast(0), "0", "Dry friction."),
    Number("armature", "kg m^2 or kg", AtLeast(0), "0", "Added inertia."),
    Number("ref", "rad or m", kAnyNumber, "0",
           "Value of the joint in the pose that the spec gives."),
    Position({"start", Key::kStart}, "`ref`",
             "Position at the start, as in `pose`; of a ball joint w, x, y, z."),
    Number("springref", "rad or m", kAnyNumber, "0", "Position at which the spring is at rest."),
    Number("margin", "rad or m", AtLeast(0), "0",
           "Distance from a limit at which the limit begins to act."),
    Numbers("solreflimit", {1, 2}, "s, 1", kAnyNumber, "0.02 1",
            "Solver parameters of the limits."),
    Numbers("solimplimit", {1, 5}, "1, 1, rad or m, 1, 1", kAnyNumber, "0.9 0.95 0.001 0.5 2",
            "Solver parameters of the limits."),
    Numbers("solreffriction", {1, 2}, "s, 1", kAnyNumber, "0.02 1",
            "Solver parameters of the dry friction."),
    Numbers("solimpfriction", {1, 5}, "1, 1, rad/s or m/s, 1, 1", kAnyNumber,
            "0.9 0.95 0.001 0.5 2", "Solver parameters of the dry friction."),
    Number({"detent", Key::kDetent}, "Nm or N", Above(0), "",
           "The torque or force that holds the joint at either end of its `range`, and that a push "
           "must exceed: past the middle, or past `springref`, the joint snaps to the other end."),
    Row({"screw", Key::kScrew}, {"thread", R"("@is screw")"},
        "In place of `type`, `axis` and `range`: a thread. Makes the joints NAME_rise, a slide, "
        "and NAME_turn, a hinge with the other keys, and the equality NAME."),
    Row({"couple", Key::kCouple}, {"coupling", R"("@is couple")"},
        "The joint that this hinge or slide follows. Makes an equality NAME of the two."),
    kUser,
};

constexpr FieldInfo kCouplingSolref =
    Numbers("solref", {1, 2}, "s, 1", kAnyNumber, "0.02 1", "Solver parameters of the equality.");
constexpr FieldInfo kCouplingSolimp =
    Numbers("solimp", {1, 5}, "1, 1, rad or m, 1, 1", kAnyNumber,
            "0.99 0.999 0.001 0.5 2; 0.9999 0.9999 0.001 0.5 2 for a curve",
            "Solver parameters of the equality; the defaults are harder than MuJoCo's.");

constexpr FieldInfo kScrewFields[] = {
    Numbers({"axis", Key::kAxis}, {3, 3}, "any one", kAnyNumber, "0 0 1",
            "Axis of the thread in the body."),
    Required(Number({"lead", Key::kLead}, "m", kAnyNumber, "",
                    "How far a full turn moves the body along the axis; negative for a left-handed "
                    "thread.")),
    Numbers({"turns", Key::kTurns}, {1, 2}, "1", kAnyNumber, "without an end",
            "Turns that it can make: from 0, or from the first number to the second."),
    kCouplingSolref,
    kCouplingSolimp,
};

constexpr FieldInfo kCoupleFields[] = {
    Required(RefersTo("joint", Row({"joint", Key::kJoint}, FieldKind::kText,
                                   "The joint to follow, a hinge or a slide."))),
    AnyUnit(Number({"ratio", Key::kRatio}, "", kAnyNumber, "",
                   "How far this joint moves, m or rad, for each m or rad of the other one.")),
    Number({"lead", Key::kLead}, "m", kAnyNumber, "",
           "In place of `ratio`: how far this slide moves for each full turn of a hinge."),
    AnyUnit(Numbers({"polycoef", Key::kPolycoef}, {1, 5}, "", kAnyNumber, "",
                    "In place of `ratio`: coefficients, constant first, of a polynomial in the "
                    "other joint's position, in m and rad. Positions count from `ref`.")),
    kCouplingSolref,
    kCouplingSolimp,
};

constexpr Table kStartFields = {
    Row({"joint", Key::kName}, FieldKind::kText,
        "Name of the joint; of one in the body BODY of another spec or file, BODY_JOINT."),
    Row({"actuator", Key::kName}, FieldKind::kText, "In place of a joint: name of the actuator."),
    kRepetition,
    Position({"value", Key::kValue}, "", "Position of a hinge, slide or ball joint, as in qpos."),
    Numbers({"pos", Key::kPos}, {3, 3}, "m", kAnyNumber, "that of the body",
            "Position of a free body, in place of `pos` of the body."),
    kOrientation,
    Numbers({"velocity", Key::kVelocity}, {1, 6}, "rad/s or m/s", kAnyNumber, "0",
            "Velocity of the joint, as in qvel: of a free joint the velocity x y z in the frame of "
            "`pos`, then the angular velocity x y z in the frame of the body."),
    AnyUnit(Number({"ctrl", Key::kCtrl}, "", kAnyNumber,
                   "0; of a position servo the position of its joint",
                   "Control of the actuator at the start.")),
    AnyUnit(Number({"act", Key::kAct}, "", kAnyNumber,
                   "0; of a position servo the position of its joint",
                   "Activation at the start, of an actuator that has one.")),
};

constexpr Table kBodyFields = {
    kNamedEntry,
    Row({"parent", Key::kParent}, FieldKind::kText, "the root body",
        "Name of its parent, a body of an earlier entry: BODY, or BODY_INNER for a body inside the "
        "spec or file of BODY."),
    Row({"parts", Key::kParts}, structures::kParts, "The solid parts of the body."),
    Row({"spec", Key::kSpec}, FieldKind::kPlainText,
        "Another spec in place of parts, with all its bodies; a path or a bundled spec's name."),
    Row({"params", Key::kParams}, structures::kOverrides, "Parameters set for that spec."),
    kSubstitutes,
    Row({"mjcf", Key::kMjcf}, FieldKind::kText,
        "An MJCF file in place of parts, relative to the spec: one of its bodies and everything "
        "below it."),
    Row({"body", Key::kBody}, FieldKind::kText, "the first", "Which body of the MJCF file."),
    kPose,
    Row("place", {"place", R"("@is place")"},
        "In place of a pose and a parent: where it stands. Without joints it is fixed to the body "
        "that it stands on."),
    Row({"fewer", Key::kFewer}, FieldKind::kBoolean, "false",
        "Whether a body for which `place` finds no room is left out, in place of an error."),
    Word("joints", "free none", "none",
         "Its joints; without any it is fixed to its parent. `free`: a body of the world, which "
         "starts where its parent has it. Top-level joints that a spec or an MJCF file brings are "
         "removed.",
         FieldKind::kJoints),
    Row("chain", {"links", R"("@is chain")"},
        "Repeats the body as the links NAME_0, NAME_1, ... of a chain, each at the end of the one "
        "before; `joints` and the pose are those of the first link."),
    Row("sites", structures::kSites, "Sites of the body."),
    Row("regions", structures::kRegions,
        "Places on the body where other bodies can stand; `auto` finds them. Not beside `spec`, "
        "which has its own."),
    Row("cameras", structures::kCameras, "Cameras of the body."),
    Row("lights", structures::kLights, "Lights of the body."),
    Number({"mass", Key::kMass}, "kg", Above(0), "",
           "Mass of the body with everything that a spec or an MJCF file brings; the parts are "
           "scaled to it."),
    kUser,
};

constexpr FieldInfo kChainFields[] = {
    Required(Integer({"links", Key::kLinks}, Between(1, 10000), "",
                     "Number of links. MuJoCo 2.2 reads bodies nested at most 95 deep.")),
    Required(Number({"length", Key::kLength}, "m", Above(0), "",
                    "Length of the whole chain along -z, of which each link has the same share.")),
    Word({"joint", Key::kJoint}, "ball hinges", "ball",
         "What joins the links: `ball` NAME_i, or the `hinges` NAME_i_x and NAME_i_y, which do not "
         "twist."),
    Number({"range", Key::kRange}, "rad", Above(0), "without an end",
           "How far a ball joint turns, at most pi, or a hinge to each side."),
    Number("stiffness", "Nm/rad", AtLeast(0), "0",
           "Spring of each joint towards a straight chain."),
    Number("damping", "Nms/rad", AtLeast(0), "0", "Damping of each joint."),
    Number("frictionloss", "Nm", AtLeast(0), "0", "Dry friction of each joint."),
    Number("armature", "kg m^2", AtLeast(0), "0", "Added inertia of each joint."),
};

constexpr FieldInfo kPlaceFields[] = {
    Required(Row({"at", Key::kAt}, FieldKind::kText,
                 "A region or a site of an earlier body: BODY.NAME, or BODY.INNER.NAME for a body "
                 "inside the spec or file of BODY; NAME alone is one of the root body.")),
    Numbers(
        {"uv", Key::kUv}, {2, 2}, "", Between(-1, 1), "drawn uniformly",
        "Position in a region along its x and y axes: 1 is the outermost position at which the "
        "whole footprint fits. On a disc, a point of the unit disc. With `beside` 0 0, and only "
        "along that side."),
    Row({"by", Key::kBy}, FieldKind::kText, "its own frame",
        "A site of this body, NAME or INNER.NAME, whose frame is laid on that of the site `at`."),
    Row("beside", {"side of a body", R"("@is beside")"}, "An earlier body that it stands next to."),
    Number({"yaw", Key::kYaw}, "rad", Between(-2 * std::numbers::pi, 2 * std::numbers::pi),
           "drawn uniformly; at a site or with `facing` or `beside` 0",
           "Turn about the vertical: from the axes of the region or site, from where it faces, or "
           "from the direction of the body that it is beside."),
    With(structures::kFacing,
         Numbers({"facing", Key::kFacing}, {2, 3}, "", kAnyNumber, "",
                 "What its front is turned to: an earlier body, a point x, y of the root frame, "
                 "or a direction x, y, 0.")),
    Row({"lying", Key::kLying}, FieldKind::kText, "upright",
        "How it stands: `upright`, as its spec has it or, if it is not stable so, in the nearest "
        "stable way; by the name of another such way (`on_left`, `upside_down`); `any`: drawn from "
        "all of them."),
    Number({"clear", Key::kClear}, "m", AtLeast(0), "0",
           "Least distance to everything else; the region may ask for more."),
    Number({"overhang", Key::kOverhang}, "", Between(0, 1), "0",
           "Share of its footprint that may lie outside of the region."),
    Row("pile", {"order and time", R"("@is pile")"},
        "The bodies of this entry are released above the region and come to rest on each other, in "
        "a simulation."),
};

constexpr FieldInfo kPileFields[] = {
    Word({"order", Key::kOrder}, "big_first listed", "big_first",
         "Order of the releases: by size, or as the bodies are listed."),
    Number({"time", Key::kTime}, "s", Between(0.1, 60), "3",
           "How long the bodies may take to come to rest after the last release."),
};

constexpr FieldInfo kBesideFields[] = {
    Required(Row({"body", Key::kBody}, FieldKind::kText, "An earlier body.")),
    Required(Word({"side", Key::kSide}, "left right front back", "",
                  "Its side, as it is for somebody who looks where its front does.")),
    Number({"gap", Key::kGap}, "m", AtLeast(0), "0",
           "Distance between the two along that side, of the boxes around them."),
};

constexpr FieldInfo kContactFields[] = {
    Row("exclude", structures::kExcludes,
        "Pairs [BODY, BODY] of bodies that may touch without colliding; the object's name means "
        "its root body."),
};

constexpr Table kExcludeFields = {
    kName,
    kRepetition,
    Required(Row("bodies", structures::kBodyPair,
                 "The names of the two bodies: BODY, or BODY_INNER for a body inside the spec or "
                 "file of BODY.")),
};

constexpr Table kExpectationFields = {
    kRepetition,
    Row({"that", Key::kThat}, structures::kCondition,
        "A condition on parameters, `mass`, `bounds.x` and the properties of bodies."),
    Row({"gap", Key::kGap}, structures::kBodyPair,
        "The distance between two, from `min` to `max`; below 0 they are in each other."),
    Row({"touch", Key::kTouch}, structures::kBodyPair, "Two that touch, or are in each other."),
    Row({"apart", Key::kApart}, structures::kBodyPair,
        "Two that are not in each other; they may touch."),
    Row({"inside", Key::kInside}, structures::kBodyPair,
        "The first one is in the convex hull of the second one."),
    Number({"min", Key::kMin}, "m", kAnyNumber, "", "The smallest gap."),
    Number({"max", Key::kMax}, "m", kAnyNumber, "", "The largest gap."),
    Row("at", structures::kPositions,
        "Where joints stand: m or rad, of a ball joint w, x, y, z; the others as in `pose`."),
    Row({"doc", Key::kDoc}, FieldKind::kPlainText, "Why it must be so; shown when it is not."),
};

constexpr FieldInfo kDefaultsFields[] = {
    Row({"part", Key::kPart}, FieldKind::kFields, "Values for parts."),
    Row({"site", Key::kSite}, FieldKind::kFields, "Values for sites."),
    Row({"joint", Key::kJoint}, FieldKind::kFields, "Values for joints."),
};

constexpr FieldInfo kHoldingFields[] = {
    Required(Numbers("ball", {1, 2}, "m", AtLeast(0.0005), "",
                     "Diameter of the balls; two numbers: of the smallest and the largest.")),
    Integer("balls", Between(1, 50), "5", "How many."),
    Number("drop", "m", AtLeast(0), "10cm",
           "How far above the object's highest point the lowest of them begins."),
    Numbers(
        "at", {2, 2}, "m", kAnyNumber, "",
        "Where they are dropped, x and y in the world, with the object where it starts; by default "
        "in the middle of its bounding box."),
    Row("without", FieldKind::kText, "",
        "A body that is taken away before, with all that is on it: a lid, a cap."),
    Row("empties", FieldKind::kBoolean, "true",
        "Whether they must come out as the object is turned over about its x axis."),
};

constexpr FieldInfo kViewFields[] = {
    Number("azimuth", "rad", Between(-2 * std::numbers::pi, 2 * std::numbers::pi), "123deg",
           "Viewing direction about z: 0 is along x, 90deg along y."),
    Number("elevation", "rad", Between(-std::numbers::pi / 2, std::numbers::pi / 2), "-30deg",
           "Tilt of the viewing direction: -90deg is straight down."),
    Row("pose", structures::kPositions,
        "Positions of joints (m or rad) that are not at their start in pictures."),
};

constexpr FieldInfo kSettlingFields[] = {
    Number("time", "s", Above(0), "2", "How long the object is simulated."),
    Number("moved", "m", AtLeast(0), "2mm",
           "How far the centre of mass of a free body may be from its start."),
    Number("turned", "rad", AtLeast(0), "2deg", "How far a free body may have turned."),
};

constexpr Table kFittingFields = {
    kRepetition,
    Required(
        Row("hole", FieldKind::kText, "", "A site at the hole's mouth; its z axis is the way in.")),
    Numbers("peg", {1, 2}, "m", AtLeast(0.0005), "",
            "Diameter of a round peg of steel; two numbers: full sides along the site's x and y."),
    Row("body", FieldKind::kText, "", "In place of a peg, a free body of the object."),
    Row("tip", FieldKind::kText, "",
        "A site on that body, which is laid on the hole's: what goes in first, its z axis ahead."),
    Required(Number("depth", "m", Above(0), "", "How far in it must get.")),
};

constexpr Table kJointCheckFields = {
    kRepetition,
    Required(Row({"joint", Key::kJoint}, structures::kNames,
                 "The joint; or several, which are driven at the same time.")),
    Row("at", structures::kPositions,
        "Where other joints stand meanwhile: m or rad, of a ball joint w, x, y, z; the rest as in "
        "`pose`. A drawer behind a door is driven with the door open."),
    Number("overshoot", "", AtLeast(0), "", "In place of `joint_overshoot`."),
    Number("reach", "", Between(0, 1), "", "In place of `joint_reach`."),
    Number("penetration", "m", AtLeast(0), "", "In place of `joint_penetration`."),
    Number("return", "", AtLeast(0), "", "In place of `joint_return`."),
    Numbers(
        "rests", {2, 2}, "rad or m", kAnyNumber, "",
        "Lowest and highest place where the hinge or slide may be when the object has settled: a "
        "lid that must fall shut, a key that must come back up."),
    Row("skip", FieldKind::kPlainText, "", "Why it is not driven."),
};

constexpr FieldInfo kGraspingFields[] = {
    Row("sites", structures::kNames,
        "Where it is to be held; by default at the sites whose names begin with `grasp`, or, if "
        "there is none, wherever it can be."),
    Number("width", "m", Between(0.001, 2), "8cm", "How far apart the jaws can be."),
    Number("force", "N", Above(0), "30", "With what force they close."),
    Number("pull", "N", AtLeast(0), "5",
           "With what force a joint pulls at the jaws that hold what moves about it: a drawer's "
           "handle, a lid."),
    Integer("tries", Between(1, 100), "3", "How many ways to hold it are tried at each site."),
};

constexpr Table kPartCheckFields = {
    kRepetition,
    Required(Row({"part", Key::kPart}, structures::kNames,
                 "The part; or several. A part `a` of a spec that is used as `in` is `in_a`.")),
    Numbers("density", {2, 2}, "kg/m^3", AtLeast(0), "", "In place of `density`."),
    Number("thickness", "m", AtLeast(0), "", "In place of `thickness`."),
    Number("aspect", "", AtLeast(1), "", "In place of `aspect`."),
};

constexpr FieldInfo kChecksFields[] = {
    Word("profile", "none simready", "none",
         "A named set of tests besides: those of the SimReady benchmark."),
    Number("self_collision", "m", AtLeast(0), "0.01mm",
           "How deep two bodies may be in each other in the start pose. "
           "MuJoCo looks at this with every object, not only in physical checks."),
    Row("stable", FieldKind::kBoolean, "false",
        "Whether a tilt of more than `tilt` is an error, that is, whether the object must stay as "
        "it was put down, and come back when it is nudged."),
    Number("nudge", "rad", Between(0, 1.5), "10deg",
           "How far a stable object is tilted, to four sides, before it is let go; a push along "
           "the floor is as strong."),
    Number("settle_time", "s", Above(0), "3", "How long the object may take to come to rest."),
    Number("rest_speed", "m/s", Above(0), "0.01", "Below this speed the object is at rest."),
    Number("tilt", "rad", AtLeast(0), "15deg",
           "How far a stable object may lean over as it settles."),
    Number("drift", "m", AtLeast(0), "unlimited",
           "How far it may move along the floor as it settles."),
    Number("penetration", "m", AtLeast(0), "unlimited",
           "How deep contacts may get as it lands: MuJoCo's contacts are soft, and a heavy part "
           "that topples onto the floor goes deep for a moment."),
    Number("sink", "m", AtLeast(0), "1mm", "How deep contacts may be when it has settled."),
    Number("energy_gain", "", AtLeast(0), "0.02",
           "How much energy the object may gain, as a share of mass * gravity * size."),
    Row("holds", {"balls", R"("@is holds")"},
        "Balls of glass that are dropped into the object: they must stay inside for 3 s."),
    Row("settled", {"limits", R"("@is settled")"},
        "Free bodies must stay where they start: on a table, in a box, on each other."),
    Row("fits", {"list of fits", R"("@list fit")"},
        "Pegs, and bodies of the object, that must go into holes: the site's z axis is turned "
        "downwards, all else is held, and they drop in."),
    Row("grasps", {"jaws", R"("@is grasps")"},
        "Jaws that close on the object, lift and shake it: they must hold it, in at least one way "
        "at each site."),
    Row("joints", {"list of drives", R"("@list drive")"},
        "Joints that are driven in another way, or by other thresholds, than the rest."),
    Row("drive", FieldKind::kBoolean, "true", "Whether joints are driven at all."),
    Number("joint_overshoot", "", AtLeast(0), "0.05",
           "How far a joint may be beyond its range, driven or at rest, as a share of the range."),
    Number("joint_reach", "", Between(0, 1), "0.9", "Share of its range that a joint must reach."),
    Number("joint_penetration", "m", AtLeast(0), "1mm",
           "How deep bodies of the object may penetrate each other at the start and as a joint is "
           "driven."),
    Number("joint_return", "", AtLeast(0), "0.05",
           "How far from where it began a joint may end, as a share of its range."),
    Number(
        "equality_error", "", AtLeast(0), "0.02",
        "How far an equality may be from zero while its joints are driven, as a share of the way "
        "of its first joint; of a weld or a loop, of the object's size."),
    Number(
        "hinge_range", "rad", AtLeast(0), "360deg",
        "Widest range of a hinge that nothing is coupled to. An equality of bodies, and a tendon "
        "over sites, couple all joints."),
    Number("slide_range", "", AtLeast(0), "3",
           "Longest range of a slide that nothing is coupled to, as a multiple of the object's "
           "longest side."),
    Row({"parts", Key::kParts}, {"list of limits", R"("@list limit")"},
        "Parts for which other limits hold than for the rest."),
    Numbers("density", {2, 2}, "kg/m^3", AtLeast(0), "20 22000",
            "Lowest and highest density of a part."),
    Numbers("bulk_density", {2, 2}, "kg/m^3", AtLeast(0), "1 22000",
            "Lowest and highest mass of the whole over the volume of its bounding box."),
    Number("overlap", "", AtLeast(0), "0.05",
           "Share of a body's mass that may be counted twice because parts overlap."),
    Number("thickness", "m", AtLeast(0), "1mm", "Thinnest part."),
    Number(
        "aspect", "", AtLeast(1), "100",
        "Longest side of a part over its shortest. Shapes that collide as several pieces are not "
        "looked at."),
    Number("gap", "m", AtLeast(0), "0.5mm",
           "How far apart parts may be and still count as one piece."),
    Number("look", "", AtLeast(0), "0.2",
           "How far what is seen of a body may reach beyond what collides, or the reverse, as a "
           "share of the body's size."),
    Row("silence", FieldKind::kSilence,
        "Findings to leave out, each with the reason: `physics/CODE: reason`, "
        "`spec/unused: reason`."),
};

}  // namespace

const ElementInfo kObjectElement = {"object", "The whole spec: one mapping.", kObjectFields};
const ElementInfo kParameterElement = {
    "parameter",
    "The long form of a parameter: a value (`value` or a distribution) with its meaning.",
    kParameterFields};
const ElementInfo kMaterialElement = {
    "material", "How parts look, and the physical properties of what they are made of.",
    kMaterialFields};
const ElementInfo kTextureElement = {"texture", "A picture or a generated pattern.",
                                     kTextureFields};
const ElementInfo kPartElement = {
    "part", "A solid of the body, written as MJCF geoms; or a frame, or another spec welded in.",
    kPartFields};
const ElementInfo kFrameElement = {"frame", "A rigid offset in the body's frame.", kPose};
const ElementInfo kSiteElement = {"site", "A named place on the body.", kSiteFields};
const ElementInfo kRegionElement = {
    "region", "A level place on the body where other bodies can stand; z points up.",
    kRegionFields};
const ElementInfo kCameraElement = {"camera", "A camera that moves with the body.", kCameraFields};
const ElementInfo kLightElement = {"light", "A light that moves with the body.", kLightFields};
const ElementInfo kJointElement = {
    "joint", "A degree of freedom of the body relative to its parent.", kJointFields};
const ElementInfo kScrewElement = {
    "screw", "A thread: a hinge and a slide that rises by `lead` with each turn.", kScrewFields};
const ElementInfo kCoupleElement = {
    "couple", "How a joint follows another: by one of `ratio`, `lead` and `polycoef`.",
    kCoupleFields};
const ElementInfo kStartElement = {
    "start", "The start state of one joint or actuator: an entry of `pose:`.", kStartFields};
const ElementInfo kBodyElement = {
    "body", "One of several bodies of an object: parts, another spec, or an MJCF file.",
    kBodyFields};
const ElementInfo kChainElement = {
    "chain", "Links in a row: a chain, a rope, or a spring that bends.", kChainFields};
const ElementInfo kPlaceElement = {
    "place", "Where a body stands: on, in or beside others, where there is room for it.",
    kPlaceFields};
const ElementInfo kBesideElement = {"beside", "The side of a body that another one stands at.",
                                    kBesideFields};
const ElementInfo kPileElement = {
    "pile", "How bodies are released above a region, to rest on each other.", kPileFields};
const ElementInfo kContactElement = {"contact", "Contacts between the bodies.", kContactFields};
const ElementInfo kExcludeElement = {
    "exclude", "Two bodies that do not collide: the long form of [BODY, BODY].", kExcludeFields};
const ElementInfo kExpectationElement = {
    "expectation",
    "What must be true of every variant: `that`, or how two bodies or parts lie, each by its name.",
    kExpectationFields};
const ElementInfo kDefaultsElement = {
    "defaults",
    "Values for keys that entries leave out; an entry's own and its material's values win.",
    kDefaultsFields};

const ElementInfo kViewElement = {"view",
                                  "How pictures show the object, unless an option says otherwise. "
                                  "All values are fixed numbers.",
                                  kViewFields};
const ElementInfo kHoldingElement = {
    "holds",
    "Balls dropped into the object, which is held meanwhile, with its joints where they start.",
    kHoldingFields};
const ElementInfo kSettlingElement = {
    "settled", "Limits for the motion of free bodies, simulated from the start of the object.",
    kSettlingFields};
const ElementInfo kFittingElement = {
    "fit", "Something that must go into a hole: a peg, or a free body of the object.",
    kFittingFields};
const ElementInfo kGraspingElement = {"grasps", "How the object must be held by two parallel jaws.",
                                      kGraspingFields};
const ElementInfo kPartCheckElement = {"limit", "What is asked of some parts.", kPartCheckFields};
const ElementInfo kJointCheckElement = {
    "drive", "How some joints are driven, and what is asked of them.", kJointCheckFields};
const ElementInfo kChecksElement = {
    "checks",
    "What the object must do and be, besides loading in MuJoCo: thresholds of `--validate "
    "physics`. They may be expressions of parameters. Thresholds of a spec used inside another are "
    "ignored.",
    kChecksFields};

const FieldInfo* ElementInfo::Find(std::string_view key) const {
  return diag::Find(fields, key, &FieldInfo::key);
}

const FieldInfo* ElementInfo::Find(Key id) const { return diag::Find(fields, id, &FieldInfo::id); }

std::span<const ElementInfo* const> AllElements() {
  static constexpr const ElementInfo* kElements[] = {
      &kObjectElement,     &kParameterElement,   &kMaterialElement, &kTextureElement,
      &kPartElement,       &kFrameElement,       &kSiteElement,     &kRegionElement,
      &kCameraElement,     &kLightElement,       &kJointElement,    &kScrewElement,
      &kCoupleElement,     &kStartElement,       &kBodyElement,     &kChainElement,
      &kPlaceElement,      &kBesideElement,      &kPileElement,     &kContactElement,
      &kExcludeElement,    &kExpectationElement, &kDefaultsElement, &kHoldingElement,
      &kSettlingElement,   &kFittingElement,     &kGraspingElement, &kPartCheckElement,
      &kJointCheckElement, &kChecksElement,      &kViewElement};
  return kElements;
}

}  // namespace mjforge::spec
