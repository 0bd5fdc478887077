#include "fuzz/input.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "mjforge/bytes/bytes.h"

namespace mjforge::fuzz {
namespace {

namespace fs = std::filesystem;

// Below TMPDIR, which run.py removes: a crash leaves no time to do it here.
fs::path MakeFolder() {
  std::string name = (fs::temp_directory_path() / "fuzz-XXXXXX").string();
  Must(::mkdtemp(name.data()) != nullptr, "no temporary folder");
  return name;
}

}  // namespace

unsigned Input::Byte() {
  if (bytes_.empty()) return 0;
  const auto byte = static_cast<unsigned char>(bytes_.front());
  bytes_.remove_prefix(1);
  return byte;
}

std::string_view Input::Line() {
  const std::string_view line = bytes_.substr(0, bytes_.find('\n'));
  bytes_.remove_prefix(std::min(line.size() + 1, bytes_.size()));
  return line;
}

const fs::path& Folder() {
  static const fs::path folder = MakeFolder();
  return folder;
}

fs::path Put(const std::string& name, std::string_view bytes) {
  const fs::path file = Folder() / name;
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  Must(bool{stream}, "a file could not be written");
  return file;
}

void ClearFolder() {
  for (const fs::directory_entry& entry : fs::directory_iterator(Folder()))
    fs::remove_all(entry.path());
}

fs::path Specs() { return MJFORGE_FUZZ_SPECS; }

std::string WithSealChecksum(std::string text) {
  constexpr std::string_view kPlace = "@own@";
  const std::size_t at = text.rfind(kPlace);
  const std::size_t member = text.rfind(R"(,"xxh128":")", at);
  if (at == text.npos || member == text.npos) return text;
  return text.replace(at, kPlace.size(), bytes::ChecksumOf(text.substr(0, member)));
}

void Word(const diag::Findings& findings, const diag::Sources& sources) {
  for (const diag::Finding& finding : findings) {
    const std::string text = diag::RenderText(finding, sources, true);
    Must(text.ends_with('\n'), "a finding's text has no line end");
    const std::string json = diag::RenderJson(finding, sources);
    Must(json.find('\n') == std::string::npos, "a finding's JSON has several lines");
  }
}

void Must(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "MUST: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

}  // namespace mjforge::fuzz
