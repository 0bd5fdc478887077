// Mesh files: OBJ, STL.

#include "fuzz/input.h"
#include "mjforge/assemble/mesh_files.h"

namespace mjforge::fuzz {

void Run(Input input) {
  const bool is_obj = input.Bit();
  std::string why_not;
  const std::optional<assemble::MeshFile> file = is_obj ? assemble::ParseObj(input.Rest(), why_not)
                                                        : assemble::ParseStl(input.Rest(), why_not);
  Must(file || !why_not.empty(), "a mesh is refused without a reason");
  if (!file) return;
  const model::TriangleMesh& mesh = file->mesh;
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      Must(corner >= 0 && static_cast<std::size_t>(corner) < mesh.vertices.size(),
           "a triangle uses a vertex that is not there");
    }
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    Must(vertex.allFinite(), "a coordinate is not finite");
  model::FindSurfaceDefect(assemble::Scaled(mesh, {1, -2, 0.5}));
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
