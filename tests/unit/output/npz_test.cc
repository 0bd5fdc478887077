// NumPy's archives: headers, types, reproducible bytes.

#include "mjforge/output/npz.h"

#include <catch2/catch.hpp>

#include "harness/npz.h"
#include "harness/temporary_folder.h"

namespace mjforge::output {
namespace {

std::string Written(const harness::TemporaryFolder& folder, const std::string& name) {
  diag::Findings findings;
  const auto part = PartFile::Open(folder / name, findings);
  REQUIRE(part);
  NpzWriter npz(*part, findings);
  const std::uint64_t matrix[] = {2, 3};
  npz.Begin("numbers", ArrayType::kFloat64, matrix);
  const double numbers[] = {1, 2.5, -3, 4e-300, 5, 6};
  npz.Write(std::span(numbers).first(2));
  npz.Write(std::span(numbers).subspan(2));
  const std::uint64_t list[] = {2};
  npz.Begin("texts", ArrayType::kText, list, 5);
  for (const char* text : {"box", "größe"}) npz.Write(Utf32Of(text, 5));
  npz.Begin("one", ArrayType::kByte, {});
  npz.Write(std::string_view("x"));
  REQUIRE(npz.Finish());
  REQUIRE(part->Commit(false, Durability::kNone, findings));
  return folder.Read(name);
}

TEST_CASE("arrays have the types, shapes and numbers that were written") {
  const harness::TemporaryFolder folder;
  const auto arrays = harness::NpzByName(Written(folder, "x.npz"));
  REQUIRE(arrays.size() == 3);
  CHECK(arrays.at("numbers").shape == std::vector<std::uint64_t>{2, 3});
  CHECK(arrays.at("numbers").Numbers() == std::vector<double>{1, 2.5, -3, 4e-300, 5, 6});
  CHECK(arrays.at("texts").type == "<U5");
  CHECK(arrays.at("texts").Texts().front() == "box");
  CHECK(arrays.at("texts").bytes.substr(20 + 4 * 2, 4) == std::string("\xF6\0\0\0", 4));  // ö
  CHECK(arrays.at("one").shape.empty());
  CHECK(IsNpzWith(folder / "x.npz", "numbers"));
  CHECK_FALSE(IsNpzWith(folder / "x.npz", "texts"));
}

TEST_CASE("the bytes of an .npz file depend only on its content") {
  const harness::TemporaryFolder folder;
  CHECK(Written(folder, "a.npz") == Written(folder, "b.npz"));
}

TEST_CASE("a text is measured in code points") {
  CHECK(CodePoints("größe") == 5);
  CHECK(CodePoints("𝛼") == 1);
  CHECK(Utf32Of("𝛼", 2) == std::string("\xFC\xD6\x01\0\0\0\0\0", 8));
}

TEST_CASE("an array with more numbers than its shape is a bug that is noticed") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  const auto part = PartFile::Open(folder / "x.npz", findings);
  NpzWriter npz(*part, findings);
  const std::uint64_t one[] = {1};
  npz.Begin("x", ArrayType::kFloat64, one);
  const double numbers[] = {1, 2};
  CHECK_THROWS_AS(npz.Write(numbers), std::logic_error);
}

}  // namespace
}  // namespace mjforge::output
