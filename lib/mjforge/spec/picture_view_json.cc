// Conversion of the picture view of a spec to JSON text.
#include "mjforge/spec/picture_view_json.h"

#include "mjforge/spec/spec.h"

namespace mjforge::spec {

std::string ViewJson(const PictureView& view) {
  return diag::JsonObject(expr::AppendExactNumber, [&](diag::Json& json) {
    if (view.azimuth) json.Member("azimuth", *view.azimuth);
    if (view.elevation) json.Member("elevation", *view.elevation);
    json.Object("pose", [&] {
      for (const auto& position : view.pose) json.Member(position.joint, position.value);
    });
  });
}

}  // namespace mjforge::spec
