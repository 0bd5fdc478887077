// Writing of the .npz files of families, each with facts about its batch as JSON.

#include "mjforge/batch/family_files.h"

#include "mjforge/batch/sink.h"
#include "mjforge/expr/expr.h"

namespace mjforge::batch {
namespace {

family::Facts FactsOf(const manifest::Record& record, const IndexRange& all) {
  family::Facts facts;
  const auto add = [&](std::string name, const auto& value) {
    diag::Json json(expr::AppendExactNumber);
    json.Value(value);
    facts.members.emplace_back(std::move(name), json.Take());
  };
  add("version", forge::Version());
  add("spec", record.spec);
  add("spec_sha256", record.spec_sha256);
  const auto write = [&](diag::Json& json) { json.Members(record.settings); };
  facts.members.emplace_back("settings", diag::JsonObject(nullptr, write));
  add("seed", record.seed);
  add("first", all.first);
  add("count", all.count);
  add("target", record.target);
  add("pad", record.pad > 0);
  add("mocap", record.mocap);
  add("mujoco", record.mujoco);
  return facts;
}

}  // namespace

std::vector<std::unique_ptr<output::PartFile>> WriteFamilies(
    const output::Destination& destination, std::span<const std::filesystem::path> rows,
    const manifest::Record& record, const IndexRange& all, bool force, diag::Findings& findings) {
  const auto place = [&](const std::string& key) {
    std::filesystem::path file = destination.Family(key);
    MayReplaceFamily(file, force, findings);
    return file;
  };
  return family::WriteNpz(rows, FactsOf(record, all), place, findings);
}

}  // namespace mjforge::batch
