// Public parsers in a guarded process (common/base/guarded.h): on some files they crash or do not return.
#include "01_obj/loaders.h"
#include "common/base/bytes.h"
#include "common/base/guarded.h"

namespace lightwalk {

template <class Bytes>
void fields(Bytes& bytes, ObjData& data) {
    bytes(data.positions, data.uvs, data.normals, data.colors, data.corners, data.runs, data.objects, data.groups,
          data.materials, data.left_out, data.libraries);
}

namespace {

bool is_consistent(const ObjData& data) {
    const size_t positions = data.positions.size() / 3, uvs = data.uvs.size() / 2, normals = data.normals.size() / 3;
    if (data.corners.size() % 3 != 0) return false;
    for (const Corner& c : data.corners)
        if (c.position >= positions || (c.uv != none && c.uv >= uvs) || (c.normal != none && c.normal >= normals))
            return false;
    for (const Run& run : data.runs)
        if (run.first_triangle > data.triangles() || (run.material != none && run.material >= data.materials.size()) ||
            (run.object != none && run.object >= data.objects.size()))
            return false;
    for (const ColoredPosition& one : data.colors)
        if (one.position >= positions) return false;
    return true;
}

}  // namespace

ObjData parse_guarded(std::string_view text, const std::string& name, Loader loader) {
    const auto parse = loader == Loader::assimp ? parse_assimp : parse_tinyobjloader;
    const std::string reader(loader_name(loader));
    const std::string bytes = run_guarded(name, reader, limits_for(text.size()), [&] {
        ByteWriter writer;
        writer(parse(text, name));
        return std::move(writer.bytes);
    });
    ObjData data;
    ByteReader{bytes}(data);
    if (!is_consistent(data)) throw Failure("{}: {} returned an index that is out of range", name, reader);
    return data;
}

}  // namespace lightwalk
