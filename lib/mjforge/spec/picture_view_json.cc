// Conversion of the picture view of a spec to JSON text.
#include "mjforge/spec/picture_view_json.h"

#include "mjforge/spec/spec.h"

namespace mjforge::spec {

std::string ViewJson(const PictureView& view) {
  diag::Json json(expr::AppendExactNumber);
  json.StartObject();
  if (view.azimuth) json.Member("azimuth", *view.azimuth);
  if (view.elevation) json.Member("elevation", *view.elevation);
  json.Key("pose");
  json.StartObject();
  for (const PictureView::Position& position : view.pose)
    json.Member(position.joint, position.value);
  json.EndObject();
  json.EndObject();
  return json.Take();
}

}  // namespace mjforge::spec
