// Types of sensors of MuJoCo 2.2.2, and their spelling in MJCF.
#pragma once

#include <string_view>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

struct SensorType {
  mjtSensor type;
  std::string_view tag;
  // Attribute that names the sensor's target; empty if there is none. A sensor with "objname" also
  // needs "objtype".
  std::string_view object;
};
/// All enumerators of mjtSensor in MuJoCo 2.2.2, in order. Later releases insert enumerators.
inline constexpr SensorType kSensorTypes[] = {{mjSENS_TOUCH, "touch", "site"},
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

}  // namespace mjforge::engine
