// A generated variant, and the options of a batch that determine it.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/family/family.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/padding/padding.h"
#include "mjforge/sample/sample.h"
#include "mjforge/structure/structure.h"

namespace mjforge::forge {

/// A variant: its object, MJCF text, record and findings.
struct Variant {
  manifest::Record record;
  /// Null if the object could not be assembled.
  std::shared_ptr<const model::Object> object;
  mjcf::MjcfDocument document;                  // undefined if there is no object
  std::optional<mjcf::MjcfDocument> placement;  // placement.json and its files, for Options::each
  diag::Findings findings;
  structure::Structure structure;          // empty: MuJoCo did not load the variant
  std::optional<family::Numbers> numbers;  // for Options::family, if the variant is valid

  /// Returns the main file of the variant (MJCF or placement.json), with the files that it refers
  /// to.
  const mjcf::MjcfDocument& output() const { return placement ? *placement : document; }
  bool ok() const { return record.status == manifest::Status::kOk; }
};

using manifest::Layout;
using manifest::OnInvalid;
using manifest::Validation;

/// Options that apply to all variants of a batch.
struct Options {
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> place_seed = {};  // seed for the draws of `place:`; empty: `seed`
  mjcf::Target target = mjcf::Target::kMujoco;
  mjcf::AssetForm assets = mjcf::AssetForm::kInline;
  bool each = false;      // each object of a scene gets a file; `document` is then the whole scene
  std::string name = {};  // name of each object, with ${index}; empty: the spec's name
  std::uint64_t attempt = 0;  // first attempt; earlier ones are not tried
  OnInvalid on_invalid = OnInvalid::kFail;
  sample::Method sampler = sample::Method::kRandom;
  std::uint64_t batch = 0;  // number of variants; 0: unknown (sample::Sampler)
  Validation validation = Validation::kLoad;
  Layout layout = Layout::kAny;    // kOne and kSplit need a validation
  std::uint64_t layout_first = 0;  // index of the batch's first variant (for Layout::kOne, `pad`)
  /// True: the variants form a family, which contains the numbers of their compiled models.
  /// Structures may then differ in flags that depend on numbers being exactly zero or equal. Needs
  /// a validation.
  bool family = false;
  /// Padding of a family: every variant gets all geoms and sites of this number of variants from
  /// layout_first on; 0: no padding. batch::OptionsOf replaces a number above 0 (--pad sets 1) by
  /// the number of variants of the batch.
  std::uint64_t pad = 0;
  /// The geoms and sites to pad with, from FindSuperset(). Null: the generator finds them.
  std::shared_ptr<const padding::Superset> superset = nullptr;
  bool mocap = false;  // for records only: mocap bodies replace fixed bodies of the family's base
  /// Folder of the manifest. Records contain the path of the spec's file relative to this folder,
  /// or no path if the option is empty.
  std::optional<std::filesystem::path> folder = {};
  /// Name of the file in `folder` that will contain Recipe::snapshot, if the recipe has a snapshot.
  std::string snapshot_file = {};
};
inline constexpr int kMaxResamples = 100;
/// For Layout::kOne: number of variants that are tried in the search for the first valid variant.
inline constexpr std::uint64_t kMaxReferences = 100;

}  // namespace mjforge::forge
