#ifndef MJFORGE_MANIFEST_MANIFEST_H_
#define MJFORGE_MANIFEST_MANIFEST_H_

// What is known of each variant of a batch, a line of JSON each.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/manifest/reader.h"
#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/sample/sample.h"

namespace mjforge::manifest {

/// One line of manifest.jsonl: what was made, from what, and what it weighs.
struct Record {
  std::string file;     // relative to the manifest, or in the archive; empty: none was written
  std::string archive;  // relative to the manifest; empty: the file stands by itself
  std::string name;
  std::uint64_t index = 0;
  std::uint64_t seed = 0;
  std::uint64_t attempt = 0;
  std::string spec;
  std::string spec_file;  // from the manifest's folder; empty: found by name, or not known
  std::string spec_sha256;
  std::vector<std::pair<std::string, std::string>> settings;
  std::string sampler;      // empty: random
  std::uint64_t batch = 0;  // the N of samplers and exact choices; 0: nothing depends on it
  std::vector<std::pair<std::string, sample::ParameterValue>> params;
  model::MassProperties mass_properties;
  model::Bounds bounds;
  // As MuJoCo counts them in the file. nbody counts the world; 0: no object was
  // made, and masses, bounds and counts mean nothing.
  int nbody = 0;
  int njnt = 0;
  int ngeom = 0;
  std::string target;
  std::string validate;                    // "load", "none", "physics"
  std::optional<physics::Result> physics;  // where it was asked for and could be measured
  std::string on_invalid;                  // "skip", "resample"; empty: fail
  std::string status;                      // "ok", "failed", "skipped"
  std::vector<std::string> findings;       // JSON objects, as diag::RenderJson makes them
  std::string sha256;                      // of the file's bytes; empty: none was written
};

/// Appends one JSON object and a line end.
void AppendRecord(std::string& out, const Record& record);

/// What was measured, as a record's `physics` has it.
std::string PhysicsJson(const physics::Result& result);

/// Reads all back but com, inertia and counts; of the bounds the box. Nothing, and
/// why, if the line is not a record. Of nbody it only says whether there was an object.
std::optional<Record> ReadRecord(std::string_view line, std::string& why_not);

/// How `record` differs from one of the same batch, in words: "seed is 7, not
/// 3". Empty: both come from one command, whatever their indices.
std::string DifferenceOfBatch(const Record& record, const Record& other);

/// schemas/manifest.schema.json.
std::string ManifestSchema();

/// What a batch achieved. Takes no more memory for more variants, unless a
/// parameter has ever new texts: of those, the first kMaxValues count.
class Statistics {
 public:
  static constexpr std::size_t kMaxValues = 1000;

  /// Of a number, or one component of a vector.
  struct Numbers {
    std::uint64_t count = 0;
    double min = 0;
    double max = 0;
    double mean = 0;
    double m2 = 0;  // sum of squared distances from the mean
    /// Welford's update: exact enough for any count.
    void Add(double value);
    /// Of the whole population; 0 for one.
    double StandardDeviation() const;
  };
  struct Parameter {
    std::string name;
    std::vector<Numbers> numbers;  // one; of a vector one a component
    /// Of texts and booleans ("true"), and of whole numbers while they are few:
    /// each value and how often it was drawn, numbers in order, texts by name.
    std::vector<std::pair<std::string, std::uint64_t>> values;
    bool more_values = false;  // there were more than kMaxValues
  };

  void Add(const Record& record);

  std::uint64_t variants() const { return variants_; }
  /// "ok", "failed", "skipped" -> how many.
  const std::map<std::string, std::uint64_t>& statuses() const { return statuses_; }
  /// Codes of findings -> variants that have them.
  const std::map<std::string, std::uint64_t>& codes() const { return codes_; }
  /// Of the variants that are ok, in the spec's order.
  std::vector<Parameter> Parameters() const;
  const Numbers& mass() const { return mass_; }
  const Numbers& attempts() const { return attempts_; }
  /// What was measured of those that are ok, named as in the record; none where nothing was.
  struct Measured {
    std::string_view name;
    std::string_view unit;  // empty: a count or a share
    Numbers numbers;
  };
  const std::vector<Measured>& physics() const { return physics_; }

 private:
  struct Tally {
    std::string name;
    std::vector<Numbers> numbers;
    std::map<std::string, std::uint64_t> texts;
    std::map<double, std::uint64_t> whole;
    bool all_whole = true;
    bool more_values = false;
  };
  Tally& TallyOf(const std::string& name, std::size_t position);
  void AddParameter(Tally& tally, const sample::ParameterValue& value);
  void AddPhysics(const physics::Result& result);

  std::uint64_t variants_ = 0;
  std::map<std::string, std::uint64_t> statuses_;
  std::map<std::string, std::uint64_t> codes_;
  std::vector<Tally> tallies_;
  Numbers mass_;
  Numbers attempts_;
  std::vector<Measured> physics_;
};

}  // namespace mjforge::manifest

#endif  // MJFORGE_MANIFEST_MANIFEST_H_
