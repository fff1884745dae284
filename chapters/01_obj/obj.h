// Models from Wavefront OBJ files, by five loaders that differ in speed and exactness.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "01_obj/mtl.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// The loader method, slowest of ours first: textbook reads line by line with streams; scan reads once over the bytes
/// with from_chars; parallel reads chunks on threads. tinyobjloader and assimp are public libraries.
enum class Loader { textbook, tinyobjloader, assimp, scan, parallel };

std::string_view loader_name(Loader loader);
std::vector<std::string_view> loader_names();
/// Throws InputError and lists the names where there is no such loader.
Loader loader_from_name(std::string_view name);

/// "The file gives none": no uv, no normal, no object, no material.
inline constexpr uint32_t none = 0xffffffffu;

/// One corner of a face: which position, uv and normal it uses, counted from 0.
struct Corner {
    uint32_t position = none, uv = none, normal = none;
    bool operator==(const Corner&) const = default;
};

inline constexpr float no_fourth = -1;

/// The colour that some programs write behind a position: r g b, 0 to 1, sRGB. Of seven numbers the last three; they are
/// w r g b or r g b a, which a file's colours tell only together.
struct ColoredPosition {
    uint32_t position = 0;
    glm::vec3 color{1.0f};
    float fourth = no_fourth;  ///< of seven numbers
    bool operator==(const ColoredPosition&) const = default;
};

/// How many `v`, `vt` and `vn` lines.
struct Counts {
    size_t positions = 0, uvs = 0, normals = 0;
};

/// Triangles from `first_triangle` to the next run's share one object, group and material: indices into the names; and
/// a smoothing group: 0 is off, `none` where the file does not say.
struct Run {
    uint32_t first_triangle = 0, object = none, group = none, material = none, smoothing = none;
    bool operator==(const Run&) const = default;
};

/// Contents of an OBJ file, triangulated but not welded, scaled or reordered.
struct ObjData {
    std::vector<float> positions;         ///< x y z each, in file order
    std::vector<float> uvs;               ///< u v each; a missing v is 0, a third number is dropped
    std::vector<float> normals;           ///< x y z each, any length
    std::vector<ColoredPosition> colors;  ///< of positions that have one
    std::vector<Corner> corners;          ///< three for each triangle, every index in range
    std::vector<Run> runs;                ///< the first starts at triangle 0
    std::vector<std::string> objects;     ///< names after `o`, in order of first use
    std::vector<std::string> groups;      ///< after `g`
    std::vector<std::string> materials;   ///< after `usemtl`
    std::vector<std::string> left_out;    ///< other contents of the file: "lines", "free-form curves"
    std::vector<std::string> libraries;   ///< text after each `mtllib`: one name, or several
    size_t triangles() const { return corners.size() / 3; }
};

/// A face has at most so many corners, for how long a polygon takes to cut grows faster than it does.
inline constexpr size_t most_corners = 100000;

/// Reads the file. All floats are the decimal text correctly rounded (assimp and tinyobjloader do not guarantee
/// that). References to missing uvs or normals are dropped with a warning. Throws InputError, with file, line and
/// reason, for anything other than an OBJ file with at least one face. tinyobjloader and assimp run in a guarded
/// process (common/base/guarded.h).
ObjData parse_obj(const std::filesystem::path& path, Loader loader = Loader::parallel);

/// For tests: `chunk_bytes` and `threads` (0: one for each core) do not affect the result of Loader::parallel.
struct ParseOptions {
    size_t chunk_bytes = size_t{1} << 20;
    unsigned threads = 0;
};

/// As parse_obj, from memory; `name` stands for the file in messages.
ObjData parse_obj_text(std::string text, const std::string& name, Loader loader, ParseOptions options = {});

/// One mesh and one node for each `o` that has faces (or one for the file), vertices welded, parts by material, missing
/// normals filled, materials read from the MTL files. A missing MTL file or material is a warning on stderr and a
/// default material, because the shape is still worth seeing; a malformed MTL throws InputError.
Model load_obj(const std::filesystem::path& path, Loader loader = Loader::parallel, Tr tr = Tr::safe);

/// By the file name's ending.
bool is_obj(const std::filesystem::path& path);

/// Any model file: .obj through `loader`, every other format through Assimp.
Model load_model(const std::filesystem::path& path, Loader loader = Loader::parallel, Tr tr = Tr::safe);

/// Vertices and indices from triangles of index triples: equal triples become one vertex. `materials` has one for each
/// of data.materials and may have a last one for triangles without. `name` names the mesh of faces without object.
Model weld(const ObjData& data, std::vector<Material> materials, const std::string& name);

}  // namespace lightwalk
