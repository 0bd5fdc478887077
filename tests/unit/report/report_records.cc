#include "report_records.h"

namespace mjforge::report {

manifest::Record RecordOf(std::uint64_t index, const std::string& status) {
  manifest::Record record;
  record.index = index;
  record.name = "mug";
  record.spec = "mug.yaml";
  record.spec_sha256 = std::string(64, 'a');
  record.target = "mujoco";
  record.status = *manifest::Find<manifest::Status>(status);
  const double value = 0.1 + 0.01 * static_cast<double>(index % 10);
  record.params = {{"height", value}, {"shape", std::string(index % 3 == 0 ? "box" : "round")}};
  if (status != "ok") {
    record.findings = {FindingOf("mujoco/error", "it does not load")};
    return record;
  }
  record.file = "mug_" + std::to_string(index) + ".xml";
  record.sha256 = std::string(64, 'b');
  record.nbody = 2;
  record.mass_properties.mass = value;
  record.bounds.aabb.min = {0, 0, -value};
  record.bounds.aabb.max = {0.01, 0.02, value};
  return record;
}

std::string FindingOf(const std::string& code, const std::string& message,
                      const std::string& severity) {
  return R"({"severity":")" + severity + R"(","code":")" + code +
         R"(","file":"mug.yaml","line":3,"column":5,"message":")" + message +
         R"(","hint":"mend it"})";
}

std::string ManifestOf(std::uint64_t count, std::uint64_t bad) {
  std::string text;
  for (std::uint64_t i = 0; i < count; ++i) {
    const bool is_bad = bad > 0 && i % bad == bad - 1;
    manifest::AppendRecord(text, RecordOf(i, is_bad ? "failed" : "ok"));
  }
  return text;
}

std::size_t Count(const std::string& text, std::string_view words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
  return count;
}

Thumbnail Picture(std::size_t bytes) { return {std::string(bytes, 'x'), 320, 240}; }

}  // namespace mjforge::report
