// Batches of a crate for tests.

#include "crate_batch.h"

#include <catch2/catch.hpp>

namespace mjforge::batch {

CrateBatch::CrateBatch(const std::string& text) {
  diag::Findings findings;
  const std::string file = folder.Write("crate.yaml", text).string();
  std::optional<forge::Recipe> loaded = forge::LoadRecipe(file, {}, sources_, findings);
  for (const diag::Finding& finding : findings) {
    UNSCOPED_INFO(diag::RenderText(finding, sources_, false));
  }
  REQUIRE(loaded);
  recipe_ = *std::move(loaded);
}

std::string Png(char end) {
  const std::string picture(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\2\0\0\0\x90wS\xde\0\0\0\x0cIDATx\x9c"
      "c\xf8\xcf\xc0\0\0\3\1\1\0\xc9\xfe\x92\xef\0\0\0\0IEND\xae"
      "B`\x82",
      69);
  return picture + end;
}

Request CrateBatch::Of(std::uint64_t count, const std::string& output,
                       std::uint64_t per_archive) const {
  Request request;
  request.count = count;
  request.variant.seed = 1;
  request.variant.validation = forge::Validation::kNone;
  request.jobs = 2;
  request.durability = output::Durability::kNone;  // no test cuts the power
  std::string why_not;
  const auto destination =
      output::ParseDestination((folder / output).string(), per_archive, why_not);
  REQUIRE(destination);
  request.destination = *destination;
  return request;
}

Summary CrateBatch::Make(const Request& request, const Observer& observer) {
  return Run(recipe_, sources_, request, observer);
}

std::string CrateBatch::ManifestText(const std::string& output) const {
  std::string why_not;
  auto lines = bytes::LineReader::Open(Of(1, output).destination.Manifest({}), why_not);
  REQUIRE(lines);
  std::string text;
  for (std::string line; lines->Next(line, why_not);) text += line + "\n";
  CHECK(why_not.empty());
  return text;
}

Summary CrateBatch::MakeUpTo(Request request, std::uint64_t count) {
  std::atomic<bool> stop = false;
  request.stop = &stop;
  request.jobs = 1;  // two workers may finish the batch before the first chunk is taken
  Observer observer;
  observer.variant = [&](const FinishedVariant& done) {
    if (done.index + 1 >= count) stop = true;
  };
  return Make(request, observer);
}

std::map<std::string, std::string> CrateBatch::Bytes(const std::string& subfolder) const {
  std::map<std::string, std::string> bytes;
  for (const std::string& file : folder.Files()) {
    if (file.starts_with(subfolder + "/"))
      bytes.emplace(file.substr(subfolder.size() + 1), folder.Read(file));
  }
  return bytes;
}

}  // namespace mjforge::batch
