// Validation of documents by MuJoCo.
#include "mjforge/validate/validate.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

#include "../mjcf/hand_made.h"

namespace mjforge::validate {
namespace {

using harness::TemporaryFolder;

using hand_made::Line;

mjcf::MjcfDocument Written(const model::Object& object,
                           mjcf::Target target = mjcf::Target::kMujoco) {
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, target, {}, document);
  return document;
}

/// Each finding as "line: code: message".
std::vector<std::string> FindingsOf(const mjcf::MjcfDocument& document,
                                    const model::Object& object) {
  static Loader loader;
  diag::Findings findings;
  const bool ok = loader.Validate(document, object, findings);
  CHECK(ok == findings.empty());
  CHECK(ok != findings.HasErrors());
  std::vector<std::string> texts;
  for (const diag::Finding& f : findings) {
    texts.push_back(std::to_string(f.mark.line) + ": " + std::string(diag::CodeName(f.code)) +
                    ": " + f.message);
  }
  return texts;
}

using Texts = std::vector<std::string>;

TEST_CASE("objects load in both targets as they are meant") {
  const model::Object mallet = hand_made::Mallet();
  const model::Object wedge = hand_made::Wedge();
  for (const mjcf::Target target : {mjcf::Target::kMujoco, mjcf::Target::kScene}) {
    CHECK(FindingsOf(Written(mallet, target), mallet) == Texts{});
    CHECK(FindingsOf(Written(wedge, target), wedge) == Texts{});
  }
  CHECK_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST_CASE("random composites compile to the mass properties we computed") {
  std::mt19937 random(7);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random()) / 4294967296.0;
  };
  constexpr model::GeomType kTypes[] = {model::GeomType::kSphere, model::GeomType::kCapsule,
                                        model::GeomType::kEllipsoid, model::GeomType::kCylinder,
                                        model::GeomType::kBox};
  for (int i = 0; i < 200; ++i) {
    model::Object object = hand_made::Empty("random");
    const double scale = std::pow(10, uniform(-2.5, 0.5));
    for (auto n = 1 + random() % 8; n > 0; --n) {
      const Eigen::Vector3d size(uniform(0.1, 1), uniform(0.1, 1), uniform(0.1, 1));
      const Eigen::Vector3d pos(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2));
      const Eigen::Vector3d euler(uniform(-3, 3), uniform(-3, 3), uniform(-3, 3));
      object.bodies[0].parts.push_back(hand_made::Solid("g" + std::to_string(n),
                                                        kTypes[random() % 5], scale * size,
                                                        {scale * pos, model::FromEuler(euler)}, 3));
    }
    hand_made::Weigh(object);
    INFO("composite " << i);
    REQUIRE(FindingsOf(Written(object), object) == Texts{});
  }
}

TEST_CASE("a stated inertia is compiled exactly") {
  model::Object object = hand_made::Mallet();
  object.bodies[0].explicit_inertial = true;
  object.bodies[0].mass_properties.I_Cm_F *= 1e-6;  // far below mju_eig3's cutoff
  CHECK(FindingsOf(Written(object), object) == Texts{});
}

TEST_CASE("a static body of massless parts loads") {
  model::Object object = hand_made::Mallet();
  object.bodies[0].joints.clear();
  for (model::Part& part : object.bodies[0].parts) {
    part.role = model::Role::kVisual;
    part.mass = part.density = 0;
  }
  hand_made::Weigh(object);
  CHECK(FindingsOf(Written(object), object) == Texts{});
}

TEST_CASE("limits that are met at once and dry friction fit the tight sizes") {
  model::Object object = hand_made::Mallet();
  object.bodies[0].joints.clear();
  for (const char* type : {"slide", "hinge"}) {
    model::Joint& joint = object.bodies[0].joints.emplace_back();
    joint.name = std::string("j_") + type;
    joint.type = type;
    joint.range = Eigen::Vector2d(0.5, 0.6);  // 0 is outside
    joint.attributes = {hand_made::Numbers("frictionloss", spec::Applies::kBoth, {1}),
                        hand_made::Numbers("margin", spec::Applies::kBoth, {9})};
  }
  CHECK(FindingsOf(Written(object), object) == Texts{});
}

TEST_CASE("a scene of a hundred boxes flat on the floor loads without a warning") {
  model::Object object = hand_made::Empty("tiles");
  for (int i = 0; i < 100; ++i) {
    object.bodies[0].parts.push_back(
        hand_made::Solid("t" + std::to_string(i), model::GeomType::kBox, {0.02, 0.02, 0.02},
                         {{0.05 * (i % 10), 0.05 * (i / 10), 0}, {1, 0, 0, 0}}, 3));
  }
  hand_made::Weigh(object);
  CHECK(FindingsOf(Written(object, mjcf::Target::kScene), object) == Texts{});
}

TEST_CASE("MuJoCo's refusal is reported at the entry that made the line") {
  const model::Object object = hand_made::Mallet();
  mjcf::MjcfDocument document = Written(object);
  const std::size_t size = document.text.find("size=\"0.04 ");
  document.text.replace(size, 11, "size=\"-0.04 ");
  Loader loader;
  diag::Findings findings;
  CHECK_FALSE(loader.Validate(document, object, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kMujocoError);
  CHECK(findings[0].mark == Line(12));
  constexpr bool kOlder = mjVERSION_HEADER < 300;
  const std::string reason = kOlder ? "sizes must be positive in object 'mallet_head' (id = 2)"
                                    : "size 0 must be positive in geom";
  CHECK(findings[0].message == "MuJoCo refused geom 'mallet_head': " + reason);
  REQUIRE(findings[0].notes.size() == 1);
  CHECK(findings[0].notes[0].message ==
        "MuJoCo said: Error: " + reason +
            (kOlder ? " Object name = mallet_head, id = 2, line = 10, column = -1"
                    : " Element name 'mallet_head', id 2, line 10"));

  diag::Findings none;
  CHECK(loader.Validate(Written(object), object, none));
  CHECK(none.empty());
}

TEST_CASE("a text that is not MJCF is refused, not compared") {
  const model::Object object = hand_made::Mallet();
  mjcf::MjcfDocument document = Written(object);
  document.text.resize(document.text.size() / 2);
  const Texts texts = FindingsOf(document, object);
  REQUIRE(texts.size() == 1);
  CHECK(texts[0].find("mujoco/error: MuJoCo refused ") != std::string::npos);
}

TEST_CASE("a warning is an error of the object") {
  const model::Object object = hand_made::Mallet();
  mjcf::MjcfDocument document = Written(object);
  const std::size_t friction = document.text.find("friction=\"0.9");
  document.text.replace(friction, 13, "friction=\"nan");
  CHECK(FindingsOf(document, object) ==
        Texts{"1: mujoco/warning: MuJoCo warns: XML contains a 'NaN'. Please check it carefully",
              "11: mujoco/mismatch: MuJoCo compiled friction 1 of geom 'mallet_handle' as nan, not "
              "0.9"});
}

/// The mallet with a file mesh as its only part.
model::Object WithMeshFile(const std::filesystem::path& file, const std::string& output_file) {
  model::Object object = hand_made::Wedge();
  object.meshes[0]->file = file;
  object.meshes[0]->output_file = output_file;
  return object;
}

/// The wedge's own vertices as an OBJ file.
void WriteObj(const std::filesystem::path& file, const model::TriangleMesh& mesh) {
  std::ofstream out(file);
  out.precision(17);
  for (const auto& v : mesh.vertices) out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& t : mesh.triangles) {
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
}

TEST_CASE("a mesh file is found under its name in the text, whatever its case") {
  const TemporaryFolder folder;
  WriteObj(folder.path() / "W.OBJ", hand_made::Wedge().meshes[0]->mesh);
  const model::Object object = WithMeshFile(folder.path() / "W.OBJ", "Wedge_1.obj");
  CHECK(FindingsOf(Written(object), object) == Texts{});
}

TEST_CASE("a missing mesh file is reported at its entry") {
  const TemporaryFolder folder;
  const model::Object object = WithMeshFile(folder.path() / "none.obj", "none.obj");
  CHECK(FindingsOf(Written(object), object) ==
        Texts{"31: model/file-not-found: cannot read '" + (folder.path() / "none.obj").string() +
              "': No such file or directory"});
  std::filesystem::create_directory(folder.path() / "none.obj");
  CHECK(FindingsOf(Written(object), object) ==
        Texts{"31: yaml/cannot-read: cannot read '" + (folder.path() / "none.obj").string() +
              "': it is a folder"});
}

TEST_CASE("two files whose names differ only in case are refused") {
  const TemporaryFolder folder;
  WriteObj(folder.path() / "a.obj", hand_made::Wedge().meshes[0]->mesh);
  WriteObj(folder.path() / "b.obj", hand_made::Wedge().meshes[0]->mesh);
  const model::Object object = WithMeshFile(folder.path() / "a.obj", "part.obj");
  mjcf::MjcfDocument document = Written(object);
  document.assets.push_back({"assets/Part.obj", folder.path() / "b.obj"});
  CHECK(FindingsOf(document, object) ==
        Texts{"0: mujoco/error: 'assets/Part.obj' differs from another file's name only in case or "
              "folder, which MuJoCo cannot tell apart"});
}

TEST_CASE("a texture that is no picture is refused at its entry") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "oak.png") << "not a picture";
  model::Object object = hand_made::Mallet();
  model::Texture texture;
  texture.name = "oak";
  texture.files.push_back({"file", folder.path() / "oak.png", "oak.png"});
  texture.mark = Line(40);
  object.textures.push_back(texture);
  const Texts texts = FindingsOf(Written(object), object);
  REQUIRE_FALSE(texts.empty());
  CHECK(texts.back().find("40: mujoco/error: MuJoCo refused texture 'oak': ") == 0);
}

TEST_CASE("the library's version is the one that it was built with") {
  CHECK(MujocoVersion() == MJFORGE_MUJOCO_VERSION);
}

/// Returns a shelf with this many free boxes on it, which have four contacts each.
model::Object Shelf(int boxes) {
  model::Object shelf = hand_made::Empty("shelf");
  const auto add = [&](model::Body& body, const std::string& name, const Eigen::Vector3d& size,
                       double z) {
    body.parts.push_back(
        hand_made::Solid(name, model::GeomType::kBox, size, {{0, 0, z}, {1, 0, 0, 0}}, 3));
  };
  add(shelf.bodies[0], "board", {5, 5, 0.1}, -0.1);
  for (int i = 0; i < boxes; ++i) {
    model::Body& body = shelf.bodies.emplace_back();
    body.name = "box" + std::to_string(i);
    body.X_PB.p = {0.3 * (i - 15), 0, -1e-6};
    body.mark = Line(4);
    body.joints.emplace_back().name = "joint" + std::to_string(i);
    add(body, "cube" + std::to_string(i), {0.1, 0.1, 0.1}, 0.1);
  }
  hand_made::Weigh(shelf);
  shelf.mass_properties.mass += 4.0 * boxes;
  return shelf;
}

TEST_CASE("too little memory in MuJoCo 2.2 is a warning, and the file asks for enough") {
  const model::Object shelf = Shelf(30);
  mjcf::MjcfDocument document = Written(shelf);
  Loader loader;
  diag::Findings findings;
  CHECK(loader.Validate(document, shelf, findings));
  CHECK(findings.empty());
  const std::size_t size = document.text.find("nconmax=\"120\"");
  REQUIRE(size != std::string::npos);
  document.text.replace(size, 13, "nconmax=\"100\"");
  CHECK(loader.Validate(document, shelf, findings));
  if (mjVERSION_HEADER >= 230) return;
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kMujocoOlder);
  CHECK(findings[0].severity == diag::Severity::kWarning);
  CHECK(findings[0].message == "MuJoCo 2.2.2 ignores contacts that exceed its buffer");
}

}  // namespace
}  // namespace mjforge::validate
