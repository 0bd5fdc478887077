// Pictures, as pages take them from outside: PNG and WebP.

#include "fuzz/input.h"
#include "mjforge/report/picture_bytes.h"

namespace mjforge::fuzz {

void Run(Input input) {
  report::ReadPictureInfo(input.Rest());
  const std::string text = report::Base64(input.Rest());
  Must(text.size() == (input.Rest().size() + 2) / 3 * 4, "a text in Base64 is cut short");
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
