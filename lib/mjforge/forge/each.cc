// Writing of each object of a scene to its own file, and of placement.json with the objects' poses.

#include <algorithm>
#include <filesystem>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// Returns the path of an object's file, relative to the folder of placement.json.
std::string FileOf(const std::string& name, const mjcf::TargetRules& rules) {
  if (rules.file_in_folder.empty()) return name + std::string(output::kObjectEnding);
  return name + '/' + std::string(rules.file_in_folder);
}

// Adds those findings of `found` that `findings` does not contain yet, because several objects that
// are made from the same spec cause the same findings.
void AddNew(const diag::Findings& found, diag::Findings& findings) {
  for (const diag::Finding& finding : found) {
    const bool is_known = std::ranges::any_of(findings, [&](const diag::Finding& known) {
      return known.mark == finding.mark && known.code == finding.code &&
             known.message == finding.message;
    });
    if (!is_known) findings.Add(finding);
  }
}

void AddJoints(const model::Object& object, manifest::PlacedFile& placed) {
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (joint.type == "free") continue;
      placed.joints.emplace_back(joint.name,
                                 joint.start.empty() ? model::ZeroPosition(joint) : joint.start);
    }
  }
}

}  // namespace

bool Generator::SplitScene(const model::Object& scene, Variant& variant) {
  const mjcf::TargetRules& rules = mjcf::RulesOf(options_.target);
  auto parts = split::Split(scene, {rules.has_prefix, rules.root}, variant.findings);
  if (!parts) return false;
  parts_ = *std::move(parts);
  return true;
}

bool Generator::WritePart(split::ScenePart& part, manifest::PlacedFile& placed, Variant& variant) {
  model::Object& object = part.object;
  diag::Findings found;
  mjcf::Adapt(object, options_.target, found);
  mjcf::Provenance provenance = variant.record;
  if (provenance.name == recipe_.spec->name) provenance.name.clear();
  provenance.part = placed.name;
  mjcf::MjcfDocument document;
  if (!found.HasErrors()) {
    mjcf::WriteMjcf(object, options_.target, provenance, document);
    files_.Make(object, document, found);
  }
  AddNew(found, variant.findings);
  if (found.HasErrors()) return false;
  AddJoints(object, placed);
  // Ignores warnings, because the validation of the whole scene has already added them.
  if (diag::Findings loaded; loader_ && !loader_->Validate(document, object, loaded)) {
    AddNew(loaded, variant.findings);
    return false;
  }
  const std::filesystem::path folder = std::filesystem::path(placed.file).parent_path();
  bytes::Assets& assets = variant.placement->assets;
  for (bytes::Asset& asset : document.assets) {
    asset.name = (folder / asset.name).generic_string();
    if (std::ranges::count(assets, asset.name, &bytes::Asset::name) == 0)
      assets.push_back(std::move(asset));
  }
  assets.push_back(
      {.name = placed.file, .made = std::make_shared<const std::string>(std::move(document.text))});
  return true;
}

bool Generator::WriteEach(Variant& variant) {
  manifest::Placement placement = {variant.record, {}, {}};
  const auto options = model::ElementsOf(*variant.object, "option");
  placement.options.assign(options.begin(), options.end());
  variant.placement.emplace();
  bool is_good = true;
  for (split::ScenePart& part : parts_) {
    manifest::PlacedFile& placed = placement.objects.emplace_back();
    placed.name = part.object.name;
    placed.file = FileOf(placed.name, mjcf::RulesOf(options_.target));
    placed.pose = part.X_WO;
    placed.at = part.at;
    placed.is_free = part.is_free;
    is_good &= WritePart(part, placed, variant);
  }
  variant.placement->text = manifest::PlacementText(placement);
  return is_good;
}

}  // namespace mjforge::forge
