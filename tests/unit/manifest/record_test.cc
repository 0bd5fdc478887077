// Tests of writing, reading and comparing records.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

Record WholeRecord() {
  Record record;
  record.file = "mug_000003.xml";
  record.name = "mug";
  record.index = 3;
  record.seed = std::numeric_limits<std::uint64_t>::max();
  record.attempt = 2;
  record.spec = "containers/mug";
  record.spec_sha256 = std::string(64, 'a');
  record.settings = {{"height", "8cm .. 12cm"}};
  record.params = {{"height", 0.1},
                   {"handle", true},
                   {"shape", std::string("a \"b\"")},
                   {"half_size", std::vector<double>{0.1, 2, 1e-9}},
                   {"there", std::vector<bool>{true, false}}};
  record.mass_properties.mass = 0.1 + 0.2;
  record.mass_properties.p_FCm = {1, 2, 3};
  record.mass_properties.I_Cm_F << 1, 4, 5, 4, 2, 6, 5, 6, 3;
  record.bounds.aabb.min = {-1, -2, -3};
  record.bounds.aabb.max = {1, 2, 3};
  record.bounds.top_offset = 3;
  record.bounds.bottom_offset = -3;
  record.bounds.horizontal_radius = 2.5;
  record.nbody = 2;
  record.njnt = 1;
  record.ngeom = 4;
  record.target = "mujoco";
  record.validate = Validation::kLoad;
  record.mujoco = "2.2.2";
  record.status = Status::kOk;
  record.findings = {R"({"severity":"warning"})"};
  record.sha256 = std::string(64, 'b');
  return record;
}

std::string LineOf(const Record& record) {
  std::string line;
  AppendRecord(line, record);
  return line;
}

TEST_CASE("a line gets its archive and its spec's file as if it had been written with them") {
  Record record = WholeRecord();
  record.spec = R"(a","spec_sha256":"b)";
  const std::string without = LineOf(record);
  record.archive = "mugs \"1\".tar";
  for (const std::string file : {"", "../mug.yaml"}) {
    record.spec_file = file;
    std::string with = "before ";
    AppendWithPaths(with, without, record.archive, record.spec_file);
    CHECK(with == "before " + LineOf(record));
  }
}

TEST_CASE("numbers are read back to the last bit") {
  for (const double number : {4.5142156799999997e-07, 0.1 + 0.2, 5e-324, 2.2250738585072011e-308,
                              std::numeric_limits<double>::max(), 9007199254740993.0,
                              18446744073709551616.0, -0.75, -0.0}) {
    Record record = WholeRecord();
    record.mass_properties.mass = number;
    record.params = {{"size", number}};
    std::string why_not;
    const std::optional<Record> read = ReadRecord(LineOf(record), why_not);
    REQUIRE(read);
    CHECK(read->mass_properties.mass == number);
    CHECK(LineOf(*read) == LineOf(record));
  }
}

TEST_CASE("a byte order mark before a record is ignored, a zero byte after it is not") {
  const std::string line = LineOf(WholeRecord());
  std::string why_not;
  CHECK(ReadRecord("\xEF\xBB\xBF" + line, why_not));
  CHECK_FALSE(ReadRecord(line + '\0', why_not));
  CHECK_FALSE(ReadRecord(line + '\0' + line, why_not));
}

TEST_CASE("a zero of many digits is a number, one too large for any number is not") {
  const std::string line = LineOf(WholeRecord());
  const std::string mass = R"("mass":0.30000000000000004)";
  const auto with_mass = [&](const std::string& number) {
    return std::string(line).replace(line.find(mass), mass.size(), "\"mass\":" + number);
  };
  std::string why_not;
  const auto zero = ReadRecord(with_mass("0." + std::string(40, '0')), why_not);
  REQUIRE(zero);
  CHECK(zero->mass_properties.mass == 0);
  CHECK_FALSE(ReadRecord(with_mass("1e999"), why_not));
  CHECK(why_not == "it is not a JSON object");
}

TEST_CASE("a record is one line of JSON in a fixed order, with exact numbers") {
  CHECK(LineOf(WholeRecord()) ==
        R"({"file":"mug_000003.xml","name":"mug","index":3,"seed":18446744073709551615,)"
        R"("attempt":2,"spec":"containers/mug","spec_sha256":")" +
            std::string(64, 'a') +
            R"(","set":{"height":"8cm .. 12cm"},"params":{"height":0.1,"handle":true,)"
            R"("shape":"a \"b\"","half_size":[0.1,2,1e-09],"there":[true,false]},)"
            R"("mass":0.30000000000000004,)"
            R"("com":[1,2,3],"inertia":[1,2,3,4,5,6],"aabb":{"min":[-1,-2,-3],"max":[1,2,3]},)"
            R"("top_offset":3,"bottom_offset":-3,"horizontal_radius":2.5,"nbody":2,"njnt":1,)"
            R"("ngeom":4,"target":"mujoco","validate":"load","mujoco":"2.2.2","status":"ok",)"
            R"("findings":[{"severity":"warning"}],)"
            R"("sha256":")" +
            std::string(64, 'b') + "\"}\n");
}

TEST_CASE("a variant that could not be built has nulls and no settings that were not made") {
  Record record;
  record.name = "mug";
  record.spec = "mug.yaml";
  record.spec_sha256 = "c";
  record.target = "mujoco";
  record.validate = Validation::kNone;
  record.status = Status::kFailed;
  CHECK(
      LineOf(record) ==
      R"({"file":null,"name":"mug","index":0,"seed":0,"attempt":0,"spec":"mug.yaml",)"
      R"("spec_sha256":"c","params":{},"mass":null,"com":null,"inertia":null,"aabb":null,)"
      R"("top_offset":null,"bottom_offset":null,"horizontal_radius":null,"nbody":null,)"
      R"("njnt":null,"ngeom":null,"target":"mujoco","validate":"none","status":"failed","findings":[],)"
      R"("sha256":null})"
      "\n");
}

TEST_CASE("what only some batches have stands in its place") {
  Record record = WholeRecord();
  record.archive = "mugs_00000.tar";
  record.assets_as = "files";
  record.sampler = "latin";
  record.batch = 100;
  record.on_invalid = OnInvalid::kSkip;
  record.structure = "0123456789ab";
  record.bounds.declared = true;
  const std::string line = LineOf(record);
  CHECK(line.find(R"("file":"mug_000003.xml","archive":"mugs_00000.tar","name")") != line.npos);
  CHECK(line.find(R"("assets_as":"files","sampler":"latin","batch":100,"params")") != line.npos);
  CHECK(line.find(R"("mujoco":"2.2.2","structure":"0123456789ab","on_invalid":"skip","status")") !=
        line.npos);
  CHECK(line.find(R"("horizontal_radius":2.5,"declared_bounds":true,"nbody")") != line.npos);
  std::string why_not;
  const std::optional<Record> read = ReadRecord(line, why_not);
  REQUIRE(read);
  CHECK(read->bounds.declared);
  CHECK(read->archive == record.archive);
  CHECK(read->assets_as == record.assets_as);
  CHECK(read->sampler == record.sampler);
  CHECK(read->batch == record.batch);
  CHECK(read->on_invalid == record.on_invalid);
  CHECK(read->structure == record.structure);
  CHECK(DifferenceOfBatch(*read, record).empty());
}

TEST_CASE("records of another batch differ in what the command said") {
  const Record record = WholeRecord();
  const auto difference = [&](auto change) {
    Record other = WholeRecord();
    change(other);
    return DifferenceOfBatch(other, record);
  };
  CHECK(difference([](Record& r) { r.index = 77; }).empty());
  CHECK(difference([](Record& r) { r.status = Status::kFailed; }).empty());
  CHECK(difference([](Record& r) { r.seed = 3; }) == "seed is '3', not '18446744073709551615'");
  CHECK(difference([](Record& r) { r.validate = Validation::kNone; }) ==
        "validate is 'none', not 'load'");
  CHECK(difference([](Record& r) { r.mujoco = "4.0.1"; }) == "mujoco is '4.0.1', not '2.2.2'");
  CHECK(difference([](Record& r) { r.settings.clear(); }) ==
        R"(set is unset, not '{"height":"8cm .. 12cm"}')");
  CHECK(difference([](Record& r) { r.place_seed = 3; }) == "place_seed is '3', not unset");
  CHECK(difference([](Record& r) { r.spec_file = "../mug.yaml"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.spec = "x"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.spec_sha256 = "x"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.assets_as = "files"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.sampler = "grid"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.batch = 2; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.target = "mjx"; }).empty());
  CHECK_FALSE(difference([](Record& r) { r.on_invalid = OnInvalid::kSkip; }).empty());
}

TEST_CASE("a record is read back as it was") {
  const Record record = WholeRecord();
  std::string why_not;
  const std::optional<Record> read = ReadRecord(LineOf(record), why_not);
  REQUIRE(read);
  CHECK(read->file == record.file);
  CHECK(read->name == record.name);
  CHECK(read->index == record.index);
  CHECK(read->seed == record.seed);
  CHECK(read->attempt == record.attempt);
  CHECK(read->spec == record.spec);
  CHECK(read->spec_sha256 == record.spec_sha256);
  CHECK(read->settings == record.settings);
  CHECK(read->params == record.params);
  CHECK(read->mass_properties.mass == record.mass_properties.mass);
  CHECK(read->mass_properties.p_FCm == record.mass_properties.p_FCm);
  CHECK(read->mass_properties.I_Cm_F == record.mass_properties.I_Cm_F);
  CHECK(read->bounds.aabb.max == record.bounds.aabb.max);
  CHECK(read->ngeom == record.ngeom);
  CHECK(read->findings == record.findings);
  CHECK(read->validate == record.validate);
  CHECK(read->mujoco == record.mujoco);
  CHECK(read->target == record.target);
  CHECK(read->sampler.empty());
  CHECK(read->batch == 0);
  CHECK(read->status == record.status);
  CHECK(read->sha256 == record.sha256);
  CHECK(LineOf(*read) == LineOf(record));
}

TEST_CASE("a line that is not a record says why") {
  const auto why = [](std::string_view line) {
    std::string why_not;
    CHECK_FALSE(ReadRecord(line, why_not).has_value());
    return why_not;
  };
  CHECK(why("") == "it is not a JSON object");
  CHECK(why("[1, 2]") == "it is not a JSON object");
  CHECK(why("{\"file\": null") == "it is not a JSON object");
  CHECK(why("{}") == "it has no 'file'");
  CHECK(why(R"({"file": 3})") == "'file' is not a text");
  CHECK(why(R"({"file": "a", "name": "b", "index": -1})") == "'index' is not a whole number");
  std::string line = LineOf(WholeRecord());
  line.replace(line.find("\"ok\""), 4, "\"lost\"");
  CHECK(why(line) == "'status' is not a word that is known here");
  // 10,000 brackets: the parser must not use the stack for them.
  CHECK(why(std::string(10'000, '[')) == "values are nested more than 64 deep");
}

}  // namespace
}  // namespace mjforge::manifest
