// Tangent frames of a mesh: the result of 04.tangent_frame at every corner, joined at the vertices.
#pragma once
#include <string>

#include "common/scene/scene.h"
#include "common/structs.h"

namespace lightwalk {

/// Mesh with a tangent frame per vertex. Vertices shared by triangles of both handednesses are duplicated, so that
/// `vertices` and `indices` may differ from the mesh's.
struct FramedMesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<TangentFrame> frames;
    std::vector<uint32_t> copies;  ///< source of each duplicate at the end of `vertices`
};

/// Frames weighted by each triangle's angle at the vertex, as for normals (G. Thürmer and C. Wüthrich, "Computing
/// Vertex Normals from Polygonal Facets", 1998). Without a direction (metres_per_uv 0), or if tangents cancel, the
/// frame is one triangle's, and metres_per_uv so large that nothing is displaced along the surface.
FramedMesh frame_mesh(const Mesh& mesh);

/// The same for the texture coordinates that each part's normal map reads.
FramedMesh frame_mesh(const Mesh& mesh, const std::vector<Material>& materials);

/// Frames of all meshes of a model, in order. Adds vertices to meshes that need duplicates, and to animated meshes the
/// derivatives that their deformation moves. Thread-safe.
std::vector<std::vector<TangentFrame>> frame_model(Model& model);

/// Name of a mesh's buffer of frames, with the code that made it, the student's or the reference.
std::string tangents_name(const Mesh& mesh);

/// Adds tangent frames to every model as the vertex attribute `tangents`, unless the current code (student or
/// reference) already made them.
void add_tangents(Gpu& gpu, const Scene& scene);

}  // namespace lightwalk
