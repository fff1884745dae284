// Tangent frames of a mesh: the result of 04.tangent_frame at every corner, joined at the vertices.
#pragma once
#include <string>

#include "common/scene/scene.h"
#include "common/structs.h"

namespace lightwalk {

/// A mesh with one frame for each vertex. A vertex that triangles of both handednesses share is there twice, so that
/// `vertices` and `indices` may differ from the mesh's.
struct FramedMesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<TangentFrame> frames;
    std::vector<uint32_t> copies;  ///< of the mesh's vertices; they stand at the end of `vertices`
};

/// Triangles count by the angle they have at the vertex, as for normals (G. Thürmer and C. Wüthrich, "Computing Vertex
/// Normals from Polygonal Facets", 1998). Where none has a direction (metres_per_uv 0), or their tangents cancel, the
/// frame is one of theirs, and metres_per_uv so large that nothing is displaced along the surface.
FramedMesh frame_mesh(const Mesh& mesh);

/// The same, of the texture coordinates that each part's normal map has.
FramedMesh frame_mesh(const Mesh& mesh, const std::vector<Material>& materials);

/// Frames of all meshes of a model, in order. Meshes are changed where their frames need more vertices; animated ones get
/// the derivatives that their deformation moves. Work for the
/// processor alone, on any thread.
std::vector<std::vector<TangentFrame>> frame_model(Model& model);

/// The name of a mesh's buffer of frames: it says whether the student's code or the reference has made them.
std::string tangents_name(const Mesh& mesh);

/// Adds tangent frames to every model as the vertex attribute `tangents`, unless the current code (student or
/// reference) already made them.
void add_tangents(Gpu& gpu, const Scene& scene);

}  // namespace lightwalk
