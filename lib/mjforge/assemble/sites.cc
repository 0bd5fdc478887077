// Reads `sites:`, and adds the sites to the current body.

#include <utility>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/pose_reader.h"
#include "mjforge/assemble/shape_reader.h"

namespace mjforge::assemble {

using spec::Key;

void Assembly::AddSites(Scope& scope, const std::vector<spec::Entry>& entries,
                        sample::StreamId sites) {
  for (const spec::Entry& entry : entries) {
    repetition_.Expand(entry, scope.values, sites, body().sites.size(),
                       [&] { AddSite(scope, entry, sites); });
  }
}

void Assembly::AddSite(Scope& scope, const spec::Entry& entry, sample::StreamId sites) {
  const std::optional<std::string> name = ReadName(scope, entry, sites, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, "site", *name,
                     sample::Child(sites, std::string_view(*name)));
  model::Site site;
  site.name = scope.prefix + *name;
  site.mark = entry.mark;
  std::string type = "sphere";
  bool good = reader.ReadOptional(entry, Key::kType, &FieldReader::Word, type);
  site.type = TypeOf(type);
  if (const spec::Field* size = entry.Find(Key::kSize)) {
    sample::Numbers numbers;
    good &= reader.Numbers(*size, numbers);
    // Sets missing components to MuJoCo's default, 0.005 m.
    numbers.resize(3, 0.005);
    site.size = Eigen::Vector3d(numbers.data());
  }
  const std::optional<model::Pose> pose = ReadPose(reader, entry);
  if (pose) site.X_BS = scope.X_BS * *pose;
  good &= pose.has_value();
  const MaterialState* material = nullptr;
  good &= materials_.Read(scope, reader, entry, material);
  if (material != nullptr) site.material = material->index;
  good &= ReadAttributes(reader, entry, site.attributes);
  if (good) body().sites.push_back(std::move(site));
}

}  // namespace mjforge::assemble
