// Seals.

#include "mjforge/manifest/seal.h"
#include "fuzz/input.h"

namespace mjforge::fuzz {

void Run(Input input) {
  std::string why_not;
  const std::optional<manifest::Seal> seal =
      manifest::ReadSeal(WithSealChecksum(std::string(input.Rest())), why_not);
  Must(seal || !why_not.empty(), "a seal is refused without a reason");
  if (!seal) return;
  const std::string text = manifest::SealText(*seal);
  const std::optional<manifest::Seal> read = manifest::ReadSeal(text, why_not);
  Must(read.has_value(), "a seal cannot be read back: " + why_not);
  Must(manifest::SealText(*read) == text, "a seal was read back as another one");
  Must(manifest::DifferenceOfOutput(*seal, *read).empty(), "a seal differs from itself");
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
