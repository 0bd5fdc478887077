// Archives: a member of a file that says it is a .tar or .tar.zst.

#include "mjforge/output/archive.h"
#include "fuzz/input.h"

namespace mjforge::fuzz {

void Run(Input input) {
  const std::filesystem::path file = Put("x.tar", input.Rest());
  diag::Sources sources;
  diag::Findings findings;
  const auto bytes = output::ReadMember(file, "x_000000.xml", findings);
  Must(bytes.has_value() != findings.HasErrors(), "no member and no error, or both");
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
