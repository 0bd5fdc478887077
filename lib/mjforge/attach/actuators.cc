// Copies actuators of the compiled model (mjModel) into an attachment, a body of an MJCF file for
// use in a spec.
#include <string_view>
#include <vector>

#include "mjforge/attach/section_reader.h"
#include "mjforge/engine/engine.h"

namespace mjforge::attach {
namespace {

/// Returns the numbers without zeros at the end, which are MuJoCo's defaults. Keeps the first
/// number, because its default is 1 in `dynprm` and `gainprm`.
std::span<const mjtNum> WithoutZeros(std::span<const mjtNum> numbers) {
  while (numbers.size() > 1 && numbers.back() == 0) numbers = numbers.first(numbers.size() - 1);
  return numbers;
}

}  // namespace

void ReadActuators(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.nu; ++i) {
    const auto& [kind, first, second] = compiled::kTransmissions[m.actuator_trntype[i]];
    const int site = second.empty() ? -1 : m.actuator_trnid[2 * i + 1];
    auto actuator =
        sections.Add("actuator", "general", mjOBJ_ACTUATOR, i,
                     {{kind, m.actuator_trnid[2 * i], first}, {mjOBJ_SITE, site, second}});
    if (!actuator) continue;
    Attributes& attributes = actuator->attributes;
    if (first == "cranksite") attributes.Number("cranklength", m.actuator_cranklength[i]);
    attributes.Read(m, mjOBJ_ACTUATOR, i);
    attributes.Text("dyntype", engine::WordOf(static_cast<mjtDyn>(m.actuator_dyntype[i])));
    attributes.Text("gaintype", engine::WordOf(static_cast<mjtGain>(m.actuator_gaintype[i])));
    attributes.Text("biastype", engine::WordOf(static_cast<mjtBias>(m.actuator_biastype[i])));
    attributes.Numbers("dynprm", WithoutZeros(Row(m.actuator_dynprm, i, mjNDYN)));
    attributes.Numbers("gainprm", WithoutZeros(Row(m.actuator_gainprm, i, mjNGAIN)));
    attributes.Numbers("biasprm", WithoutZeros(Row(m.actuator_biasprm, i, mjNBIAS)));
  }
}

}  // namespace mjforge::attach
