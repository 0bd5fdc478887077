// Copies sensors of the compiled model (mjModel) into an attachment, a body of an MJCF file for use
// in a spec.
#include <algorithm>
#include <string_view>
#include <vector>

#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

// Keywords in the order of mjtDataType and mjtStage.
constexpr std::string_view kDataTypes[] = {"real", "positive", "axis", "quaternion"};
constexpr std::string_view kStages[] = {"none", "pos", "vel", "acc"};

}  // namespace

void ReadSensors(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.nsensor; ++i) {
    const auto sensor =
        std::ranges::find(engine::kSensorTypes, m.sensor_type[i], &engine::SensorType::type);
    if (sensor == std::end(engine::kSensorTypes)) continue;
    const Reference object = {static_cast<mjtObj>(m.sensor_objtype[i]), m.sensor_objid[i],
                              sensor->object, sensor->object == "objname" ? "objtype" : ""};
    const Reference frame = {static_cast<mjtObj>(m.sensor_reftype[i]), m.sensor_refid[i], "refname",
                             "reftype"};
    std::vector<Reference> references;
    if (!sensor->object.empty()) references = {object, frame};
    auto added = sections.Add("sensor", sensor->tag, mjOBJ_SENSOR, i, references);
    if (!added) continue;
    Attributes& attributes = added->attributes;
    if (sensor->type == mjSENS_USER) {
      attributes.Text("datatype", kDataTypes[m.sensor_datatype[i]]);
      attributes.Text("needstage", kStages[m.sensor_needstage[i]]);
      attributes.Number("dim", m.sensor_dim[i]);
    }
    attributes.Read(m, mjOBJ_SENSOR, i);
  }
}

}  // namespace mjforge::attach
