// Copies sensors of the compiled model (mjModel) into an attachment, a body of an MJCF file for use
// in a spec.
#include <algorithm>
#include <string_view>
#include <vector>

#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

struct Sensor {
  mjtSensor type;
  std::string_view tag;
  // Attribute that names the sensor's target; empty if there is none. A sensor with "objname" also
  // needs "objtype".
  std::string_view object;
};
constexpr Sensor kSensors[] = {{mjSENS_TOUCH, "touch", "site"},
                               {mjSENS_ACCELEROMETER, "accelerometer", "site"},
                               {mjSENS_VELOCIMETER, "velocimeter", "site"},
                               {mjSENS_GYRO, "gyro", "site"},
                               {mjSENS_FORCE, "force", "site"},
                               {mjSENS_TORQUE, "torque", "site"},
                               {mjSENS_MAGNETOMETER, "magnetometer", "site"},
                               {mjSENS_RANGEFINDER, "rangefinder", "site"},
                               {mjSENS_JOINTPOS, "jointpos", "joint"},
                               {mjSENS_JOINTVEL, "jointvel", "joint"},
                               {mjSENS_TENDONPOS, "tendonpos", "tendon"},
                               {mjSENS_TENDONVEL, "tendonvel", "tendon"},
                               {mjSENS_ACTUATORPOS, "actuatorpos", "actuator"},
                               {mjSENS_ACTUATORVEL, "actuatorvel", "actuator"},
                               {mjSENS_ACTUATORFRC, "actuatorfrc", "actuator"},
                               {mjSENS_BALLQUAT, "ballquat", "joint"},
                               {mjSENS_BALLANGVEL, "ballangvel", "joint"},
                               {mjSENS_JOINTLIMITPOS, "jointlimitpos", "joint"},
                               {mjSENS_JOINTLIMITVEL, "jointlimitvel", "joint"},
                               {mjSENS_JOINTLIMITFRC, "jointlimitfrc", "joint"},
                               {mjSENS_TENDONLIMITPOS, "tendonlimitpos", "tendon"},
                               {mjSENS_TENDONLIMITVEL, "tendonlimitvel", "tendon"},
                               {mjSENS_TENDONLIMITFRC, "tendonlimitfrc", "tendon"},
                               {mjSENS_FRAMEPOS, "framepos", "objname"},
                               {mjSENS_FRAMEQUAT, "framequat", "objname"},
                               {mjSENS_FRAMEXAXIS, "framexaxis", "objname"},
                               {mjSENS_FRAMEYAXIS, "frameyaxis", "objname"},
                               {mjSENS_FRAMEZAXIS, "framezaxis", "objname"},
                               {mjSENS_FRAMELINVEL, "framelinvel", "objname"},
                               {mjSENS_FRAMEANGVEL, "frameangvel", "objname"},
                               {mjSENS_FRAMELINACC, "framelinacc", "objname"},
                               {mjSENS_FRAMEANGACC, "frameangacc", "objname"},
                               {mjSENS_SUBTREECOM, "subtreecom", "body"},
                               {mjSENS_SUBTREELINVEL, "subtreelinvel", "body"},
                               {mjSENS_SUBTREEANGMOM, "subtreeangmom", "body"},
                               {mjSENS_CLOCK, "clock", ""},
                               {mjSENS_USER, "user", "objname"}};

// Keywords in the order of mjtDataType and mjtStage.
constexpr std::string_view kDataTypes[] = {"real", "positive", "axis", "quaternion"};
constexpr std::string_view kStages[] = {"none", "pos", "vel", "acc"};

}  // namespace

void ReadSensors(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.nsensor; ++i) {
    const auto sensor =
        std::ranges::find(kSensors, static_cast<mjtSensor>(m.sensor_type[i]), &Sensor::type);
    if (sensor == std::end(kSensors)) continue;
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
