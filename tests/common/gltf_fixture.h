// A glTF file of one triangle, with a material and further entries of a test.
#pragma once
#include "import_fixture.h"
#include "scene_fixture.h"

namespace lightwalk {

// Two floats 0 and 1, then three positions: (0, 0, 0), (1, 0, 0), (0, 1, 0).
inline const std::string head =
    R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "buffers": [{"byteLength": 44,
    "uri": "data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
    "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "material": 0}]}], "materials": [{)";

struct Gltf {
    const FileFolder folder;
    Model read(const std::string& material, const std::string& rest = R"("nodes": [{"mesh": 0}])") {
        const auto file = folder / "model.gltf";
        write_file(file, head + material + "}], " + rest + "}");
        return import_model(file);
    }
    std::string error(const std::string& material, const std::string& rest = R"("nodes": [{"mesh": 0}])") {
        return refusal_of([&] { read(material, rest); });
    }
};

}  // namespace lightwalk
