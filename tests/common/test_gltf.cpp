// glTF as the specification has it: numbers that follow from its text, what is left out, files that must be refused.
#include <meshoptimizer.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>

#include "common/scene/asset_path.h"
#include "common/scene/bare.h"
#include "import_fixture.h"
#include "scene_fixture.h"

using namespace lightwalk;

namespace {

// Two floats 0 and 1, then three positions: (0, 0, 0), (1, 0, 0), (0, 1, 0).
const std::string head =
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

template <class T, size_t n>
std::string encoded(const std::array<T, n>& values) {
    std::string bytes(meshopt_encodeVertexBufferBound(n, sizeof(T)), '\0');
    bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), values.data(),
                                            n, sizeof(T)));
    return bytes;
}

}  // namespace

// Bytes by the extension's reference encoder: positions of 16 bits, octahedral normals, indices of triangles.
TEST_CASE("glTF: meshopt's compression and quantised attributes") {
    using Short4 = std::array<int16_t, 4>;
    using Byte4 = std::array<int8_t, 4>;
    meshopt_encodeVertexVersion(0);
    const std::array<unsigned, 3> triangle{0, 1, 2};
    std::string indices(meshopt_encodeIndexBufferBound(3, 3), '\0');
    indices.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(indices.data()), indices.size(),
                                             triangle.data(), 3));
    const std::array<glm::vec4, 3> directions{{{0, 0, 1, 1}, {1, 0, 0, 1}, {0, 0.6f, 0.8f, 1}}};
    std::array<Byte4, 3> octahedral;
    meshopt_encodeFilterOct(octahedral.data(), 3, 4, 8, &directions[0].x);
    const std::string parts[] = {encoded(std::array<Short4, 3>{{{0, 0, 0, 0}, {32767, 0, 0, 0}, {0, -32767, 500, 0}}}),
                                 encoded(octahedral), indices};
    Gltf file;
    std::string bytes, views;
    const char* const modes[] = {R"("ATTRIBUTES", "byteStride": 8)",
                                 R"("ATTRIBUTES", "byteStride": 4, "filter": "OCTAHEDRAL")",
                                 R"("TRIANGLES", "byteStride": 2)"};
    const int lengths[] = {24, 12, 6}, strides[] = {8, 4, 0};
    for (int i = 0; i < 3; ++i) {
        views += fmt::format(
            R"({}{{"buffer": 1, "byteLength": {}{}, "extensions": {{"EXT_meshopt_compression": {{"buffer": 0,
            "byteOffset": {}, "byteLength": {}, "count": 3, "mode": {}}}}}}})",
            i ? "," : "", lengths[i], strides[i] ? fmt::format(R"(, "byteStride": {})", strides[i]) : "", bytes.size(),
            parts[i].size(), modes[i]);
        bytes += parts[i];
    }
    write_file(file.folder / "packed.bin", bytes);
    write_file(file.folder / "packed.gltf",
               fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}],
        "extensionsUsed": ["EXT_meshopt_compression", "KHR_mesh_quantization"],
        "extensionsRequired": ["EXT_meshopt_compression", "KHR_mesh_quantization"], "nodes": [{{"mesh": 0}}],
        "buffers": [{{"uri": "packed.bin", "byteLength": {}}}, {{"byteLength": 42}}], "bufferViews": [{}],
        "accessors": [{{"bufferView": 0, "componentType": 5122, "normalized": true, "count": 3, "type": "VEC3"}},
                      {{"bufferView": 1, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"}},
                      {{"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1}}, "indices": 2}}]}}]}})",
                           bytes.size(), views));
    const Mesh mesh = import_model(file.folder / "packed.gltf").meshes.at(0);
    REQUIRE((mesh.vertices.size() == 3 && mesh.indices == std::vector<uint32_t>{0, 1, 2}));
    CHECK(mesh.vertices[1].position == glm::vec3(1, 0, 0));
    CHECK(glm::length(mesh.vertices[2].position - glm::vec3(0, -1, 500 / 32767.0f)) < 1e-6f);
    for (size_t i = 0; i < 3; ++i) CHECK(glm::length(mesh.vertices[i].normal - glm::vec3(directions[i])) < 0.01f);
}

TEST_CASE("glTF: a mesh compressed by Draco") {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int colors = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
    const glm::vec3 corners[] = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    const glm::u8vec4 shades[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 51, 255}};
    const draco::FaceIndex face(0);
    builder.SetAttributeValuesForFace(positions, face, &corners[0], &corners[1], &corners[2]);
    builder.SetAttributeValuesForFace(colors, face, &shades[0], &shades[1], &shades[2]);
    draco::EncoderBuffer encoded;
    REQUIRE(draco::Encoder().EncodeMeshToBuffer(*builder.Finalize(), &encoded).ok());
    Gltf file;
    write_file(file.folder / "packed.bin", std::string_view(encoded.data(), encoded.size()));
    const std::string text =
        fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
        "extensionsUsed": ["KHR_draco_mesh_compression"], "extensionsRequired": ["KHR_draco_mesh_compression"],
        "buffers": [{{"uri": "packed.bin", "byteLength": {0}}}], "bufferViews": [{{"buffer": 0, "byteLength": {0}}}],
        "accessors": [{{"componentType": 5126, "count": 3, "type": "VEC3"}},
                      {{"componentType": 5121, "normalized": true, "count": 3, "type": "VEC4"}},
                      {{"componentType": 5123, "count": 3, "type": "SCALAR"}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "COLOR_0": 1}}, "indices": 2, "extensions": {{
            "KHR_draco_mesh_compression": {{"bufferView": 0, "attributes": {{"POSITION": {1}, "COLOR_0": {2}}}}}}}}}]}}]}})",
                    encoded.size(), positions, colors);
    write_file(file.folder / "packed.gltf", text);
    const Mesh mesh = import_model(file.folder / "packed.gltf").meshes.at(0);
    REQUIRE(mesh.indices.size() == 3);
    for (int i = 0; i < 3; ++i) {  // the encoder may begin with any corner
        const auto at = std::find_if(mesh.indices.begin(), mesh.indices.end(),
                                     [&](uint32_t v) { return mesh.vertices[v].position == corners[i]; });
        REQUIRE(at != mesh.indices.end());
        CHECK(glm::length(mesh.colors[*at] - glm::vec4(shades[i]) / 255.0f) < 1e-6f);
    }
    write_file(file.folder / "packed.bin", std::string(encoded.size(), 'x'));
    CHECK_THROWS_AS(import_model(file.folder / "packed.gltf"), InputError);
}

TEST_CASE("glTF: primitives that differ in their material alone", "[common.gltf_same]") {
    const Model model = Gltf().read(R"("name": "red"}, {"name": "green")", R"("nodes": [{"mesh": 0}, {"mesh": 1}],
        "scenes": [{"nodes": [0, 1]}], "meshes": [
        {"name": "one", "primitives": [{"attributes": {"POSITION": 1}, "material": 0}]},
        {"name": "other", "primitives": [{"attributes": {"POSITION": 1}, "material": 1},
                                         {"attributes": {"POSITION": 1, "NORMAL": 1}, "material": 1}]}])");
    REQUIRE(model.meshes.size() == 3);
    const Mesh &one = model.meshes[0], &other = model.meshes[1], &with_normals = model.meshes[2];
    CHECK(one.name == "one");
    CHECK(other.name == "other");
    CHECK(one.parts[0].material == 0);
    CHECK(other.parts[0].material == 1);
    CHECK(other.indices == std::vector<uint32_t>{0, 1, 2});
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 position(i == 1, i == 2, 0);
        CHECK(other.vertices[i].position == position);
        CHECK(other.vertices[i].normal == glm::vec3(0, 0, 1));
        CHECK(with_normals.vertices[i].normal == (i > 0 ? position : glm::vec3(0, 0, 1)));  // (0, 0, 0) is none
    }
}

// glTF 2.0, 3.7.3.1: joints need a common root, which may be outside of the scene.
TEST_CASE("glTF: joints outside of the scene") {
    const std::string skinned = R"("skins": [{"joints": [2]}], "nodes": [{"mesh": 0}, {"children": [2], "translation":
        [1, 0, 0], "mesh": 0}, {"translation": [0, 2, 0]}])";
    const Model model = Gltf().read("", skinned);
    REQUIRE((model.nodes.size() == 3 && model.nodes[1].meshes.empty()));
    CHECK(glm::vec3(world_transforms(model)[2][3]) == glm::vec3(1, 2, 0));
}

// KHR_node_visibility: what is hidden is not rendered; its transforms stay.
TEST_CASE("glTF: joints that are hidden move a visible skin", "[common.hidden_joints]") {
    const std::string hidden = R"("extensions": {"KHR_node_visibility": {"visible": false}})";
    const std::string skinned = R"("skins": [{"joints": [3]}], "scenes": [{"nodes": [0, 1]}], "nodes": [{"mesh": 0},
        {"children": [2], "translation": [1, 0, 0]}, {"children": [3], "mesh": 0, )" +
                                hidden + R"(}, {"translation": [0, 2, 0], "mesh": 0}])";
    const Model model = Gltf().read("", skinned);
    REQUIRE(model.nodes.size() == 4);
    for (size_t i = 1; i < 4; ++i) CHECK(model.nodes[i].meshes.empty());
    CHECK(glm::vec3(world_transforms(model)[3][3]) == glm::vec3(1, 2, 0));
}

// glTF 2.0, 3.6.2.2: f = c / 127. A quarter turn about z has x = y = 0 and z = w: 90 / 127 each, whose length is 1.002.
TEST_CASE("glTF: rotations by normalised integers have the length 1", "[common.integer_rotation]") {
    Gltf file;
    std::string text =
        head + R"(}], "nodes": [{"mesh": 0, "children": [1]}, {"rotation": [0, 0, 0.71, 0.71]}], "animations": [{
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}], "samplers": [{"input": 0, "output": 3}]}]})";
    const std::string old = R"("count": 2, "type": "VEC3"})", view = R"("byteOffset": 8, "byteLength": 36})";
    text.replace(text.find(old), old.size(), old + R"(,
        {"bufferView": 2, "componentType": 5120, "normalized": true, "count": 2, "type": "VEC4"})");
    text.replace(text.find(view), view.size(), view + R"(, {"buffer": 1, "byteLength": 8})");
    const std::string list = R"(AAAAAACAPwAAAAA="}])";
    text.replace(text.find(list), list.size(),
                 R"(AAAAAACAPwAAAAA="}, {"byteLength": 8, "uri": "data:;base64,AABaWgAAWlo="}])");
    write_file(file.folder / "turned.gltf", text);
    const Model model = import_model(file.folder / "turned.gltf");
    const glm::mat4 quarter({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    const glm::mat4 turned = world_transforms(model, 0.5f).at(0);
    for (int i = 0; i < 4; ++i) {
        CHECK(glm::length(turned[i] - quarter[i]) < 1e-6f);
        CHECK(glm::length(model.nodes.at(1).local[i] - quarter[i]) < 1e-6f);
    }
}

// RFC 2397 and RFC 3986: a data URI may be percent-encoded; writers also break its lines, or leave out the padding.
TEST_CASE("glTF: data URIs as they are written", "[common.data_uri]") {
    Gltf file;
    const std::string whole = head + R"(}], "nodes": [{"mesh": 0}]})";
    const auto read_with = [&](const std::string& old, const std::string& by) {
        std::string text = whole;
        text.replace(text.find(old), old.size(), by);
        write_file(file.folder / "data.gltf", text);
        return import_model(file.folder / "data.gltf").meshes.at(0).vertices.at(2).position;
    };
    CHECK(read_with("PwAAAAA=", "PwAAAAA") == glm::vec3(0, 1, 0));
    CHECK(read_with("PwAAAAA=", "PwAAAAA%3D") == glm::vec3(0, 1, 0));
    CHECK(read_with("AAAAIA/", R"(AAAAIA\r\n %2F)") == glm::vec3(0, 1, 0));
    CHECK(refusal_of([&] { read_with("AAAAIA/", "AAAAIA_"); }).find("not base64") != std::string::npos);
}

// RFC 3986, 2.1: %20 is a blank. Other programs write names as they are, with backslashes, or in other capitals.
TEST_CASE("glTF: names of files as they are written", "[common.uri_names]") {
    Gltf file;
    const float floats[11] = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::filesystem::create_directory(file.folder / "parts");
    const auto position = [&](const std::string& name, const std::string& uri) {
        write_file(file.folder / "parts" / name,
                   std::string_view(reinterpret_cast<const char*>(floats), sizeof floats));
        std::string text = head + R"(}], "nodes": [{"mesh": 0}]})";
        const size_t begin = text.find("data:"), end = text.find('"', begin);
        text.replace(begin, end - begin, uri);
        write_file(file.folder / "names.gltf", text);
        const size_t bytes = bytes_to_import(file.folder / "names.gltf");
        CHECK(bytes == text.size() + sizeof floats);
        const glm::vec3 read = import_model(file.folder / "names.gltf").meshes.at(0).vertices.at(1).position;
        std::filesystem::remove(file.folder / "parts" / name);
        return read;
    };
    CHECK(position("a b.bin", "parts/a%20b.bin") == glm::vec3(1, 0, 0));
    CHECK(position("a%20b.bin", "parts/a%20b.bin") == glm::vec3(1, 0, 0));
    CHECK(position("a b.bin", R"(parts\\a b.bin)") == glm::vec3(1, 0, 0));
    CHECK(position("a.bin", "parts/A.BIN") == glm::vec3(1, 0, 0));
}

// glTF 2.0, 3.7.2.1: a primitive without positions is skipped.
TEST_CASE("glTF: a primitive without positions is skipped and named", "[common.no_positions]") {
    const Model model =
        Gltf().read("", R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"NORMAL": 1}},
        {"attributes": {"POSITION": 1}}]}])");
    CHECK(model.meshes.size() == 1);
    CHECK(left_out_text(model) == "triangles without positions (1 mesh)");
}

// glTF 2.0, 3.7.2.2: a vertex moves by the weighted sum of its primitive's targets.
TEST_CASE("glTF: weights animate primitives of which some have fewer targets", "[common.fewer_targets]") {
    const Model model =
        Gltf().read("", R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 1}},
        {"attributes": {"POSITION": 1}, "targets": [{"POSITION": 1}]}]}], "animations": [{"channels": [{"sampler": 0,
        "target": {"node": 0, "path": "weights"}}], "samplers": [{"input": 0, "output": 0}]}])");
    REQUIRE(model.meshes.size() == 2);
    const auto x = [&](size_t mesh) {
        const auto world = world_transforms(model, 0.25f);
        return model.meshes[mesh].deformation ? deformed(model, model.meshes[mesh], world, 0.25f)[1].position.x
                                              : model.meshes[mesh].vertices[1].position.x;
    };
    CHECK(x(0) == 1.0f);
    CHECK(x(1) == 1.25f);
}

TEST_CASE("glTF: motions of cameras and lights are named", "[common.moving_camera]") {
    const Model model = Gltf().read("", R"("nodes": [{"mesh": 0, "children": [1]}, {"camera": 0}, {"camera": 0}],
        "scenes": [{"nodes": [0, 2]}], "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                        "samplers": [{"input": 0, "output": 2}]}])");
    CHECK(left_out_text(model) == "motions of cameras (1 camera)");
}

// glTF 2.0, 3.11: an animation's value is that of its only key, before it and after it.
TEST_CASE("glTF: an animation of one key is a pose", "[common.one_key]") {
    Gltf file;
    std::string text = head + R"(}], "nodes": [{"mesh": 0, "translation": [5, 6, 7], "scale": [2, 2, 2]}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                        "samplers": [{"input": 3, "output": 4}]}]})";
    const std::string old = R"("count": 2, "type": "VEC3"})";
    text.replace(text.find(old), old.size(), old + R"(,
        {"bufferView": 0, "componentType": 5126, "count": 1, "type": "SCALAR"},
        {"bufferView": 1, "byteOffset": 12, "componentType": 5126, "count": 1, "type": "VEC3"})");
    write_file(file.folder / "pose.gltf", text);
    const Model model = import_model(file.folder / "pose.gltf");
    CHECK(model.motions.empty());
    CHECK(world_transforms(model, 3.0f)[0] == glm::mat4({2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {1, 0, 0, 1}));
}

// GLB: 12 bytes of header, of which the last four state the length; then chunks, whose lengths are multiples of four.
TEST_CASE("glTF: bytes behind a .glb's end, and chunks without padding", "[common.glb_ends]") {
    Gltf file;
    const auto number = [](size_t n) { return std::string{char(n), char(n >> 8), char(n >> 16), char(n >> 24)}; };
    std::string json = head + R"(}], "nodes": [{"mesh": 0}]})";
    const std::string uri =
        R"("uri": "data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=")";
    json.replace(json.find(uri), uri.size(), R"("name": "x")");
    while (json.size() % 4 != 1) json += ' ';
    const float floats[11] = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string bin(reinterpret_cast<const char*>(floats), sizeof floats);
    for (const bool is_padded : {true, false})
        for (const std::string& behind : {std::string(), std::string("behind the end, 0123456789")}) {
            CAPTURE(is_padded, behind);
            const std::string text = json + std::string(is_padded ? 3 : 0, ' ');
            const size_t length = 12 + 8 + text.size() + 8 + bin.size();
            write_file(file.folder / "a.glb", "glTF" + number(2) + number(length) + number(text.size()) + "JSON" +
                                                  text + number(bin.size()) + std::string("BIN\0", 4) + bin + behind);
            CHECK(import_model(file.folder / "a.glb").meshes.at(0).vertices[1].position == glm::vec3(1, 0, 0));
        }
}

// Exporters write colours of instances as _COLOR_0: times the material's.
TEST_CASE("glTF: colours of instances", "[common.instance_colors]") {
    const std::string nodes = R"("nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes":
        {"TRANSLATION": 1, "_COLOR_0": 1, "_OTHER": 1}}}}], "extensionsUsed": ["EXT_mesh_gpu_instancing"])";
    const Model model = Gltf().read(R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1]})", nodes);
    CHECK(left_out_text(model) == "instances' _OTHER (1 mesh)");
    Scene scene;
    SceneFile file;
    file.objects = {object_at(quad_file, {0, 0, 0})};
    scene.load(check_device(), std::move(file), [&](const auto&) { return model; });
    REQUIRE(scene.items.size() == 3);
    CHECK(scene.items[0].material.diffuse == glm::vec3(0));  // the accessor's values, times a half
    CHECK(scene.items[1].material.diffuse == glm::vec3(0.5f, 0, 0));
    CHECK(scene.items[2].material.diffuse == glm::vec3(0, 0.5f, 0));
}

// glTF 2.0, 3.9.3: a fragment whose alpha is at least the cutoff is opaque.
TEST_CASE("glTF: a cutoff of 0 hides nothing", "[common.cutoff_0]") {
    const auto why = [](const char* cutoff, const char* alpha) {
        const Model model = Gltf().read(fmt::format(
            R"("alphaMode": "MASK", "alphaCutoff": {}, "pbrMetallicRoughness": {{"baseColorFactor": [1, 1, 1, {}]}})",
            cutoff, alpha));
        return why_invisible(model, {0, 0, 5});
    };
    CHECK(why("0", "0").empty());
    CHECK(why("0.5", "0.5").empty());
    CHECK(why("0.5", "0.4").find("transparent") != std::string::npos);
}

// KHR_materials_transmission: (1 - f) of the body, and f times the base colour of what lies behind; by
// KHR_materials_volume times attenuationColor ^ (thickness / attenuationDistance). A metal transmits nothing.
TEST_CASE("glTF: thin transmission is a share of light by channel") {
    const auto glass = [](const std::string& base, const std::string& metal, const std::string& more) {
        return Gltf().read(R"("pbrMetallicRoughness": {"baseColorFactor": )" + base + R"(, "metallicFactor": )" +
                           metal + R"(}, "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75})" +
                           more);
    };
    const auto near = [](const Material& m, float opacity, glm::vec3 tint) {
        return std::abs(m.opacity - opacity) < 1e-6f && glm::length(m.transmission - tint) < 1e-6f;
    };
    Model model = glass("[0.5, 1, 0.25, 1]", "0", "}");
    CHECK(near(model.materials[0], 0.25f, {0.5f, 1, 0.25f}));
    CHECK((model.materials[0].blend && model.materials[0].illumination == 4 && left_out_text(model).empty()));
    model = glass("[1, 1, 1, 1]", "1", "}");
    CHECK((model.materials[0].opacity == 1 && model.materials[0].transmission.r < 0 && !model.materials[0].blend));
    CHECK(near(glass("[1, 1, 1, 1]", "0.5", "}").materials[0], 0.625f, glm::vec3(1)));
    // The factor of a texture is no metalness; where it says metal, nothing transmits.
    model = Gltf().read(R"("pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}, "extensions":
                        {"KHR_materials_transmission": {"transmissionFactor": 0.75}})",
                        R"("nodes": [{"mesh": 0}], "textures": [{"source": 0}], "images": [{"uri": "orm.png"}])");
    CHECK((near(model.materials[0], 0.25f, glm::vec3(1)) && model.materials[0].metalness == 1));
    CHECK(left_out_text(model) == "KHR_materials_transmission's metal by a texture (1 material)");
    model = glass("[1, 0.5, 1, 1]", "0", R"(, "KHR_materials_volume": {"thicknessFactor": 2, "attenuationDistance": 4,
                                           "attenuationColor": [0.25, 1, 0]}})");
    CHECK(near(model.materials[0], 0.25f, {0.5f, 0.5f, 0}));
    CHECK(left_out_text(model) == "KHR_materials_volume's refraction (1 material)");
    // Half covered: of 100, 50 pass beside the glass, and 50 * 0.75 * tint through it.
    model = glass("[0, 1, 1, 0.5]", "0", R"(}, "alphaMode": "BLEND")");
    CHECK(near(model.materials[0], 0.125f, {0.5f / 0.875f, 1, 1}));
    model = glass("[0, 1, 1, 0.5]", "0", R"(}, "alphaMode": "MASK")");
    CHECK(left_out_text(model) == "KHR_materials_transmission beside holes (1 material)");
}

TEST_CASE("glTF: what is left out is named once, and counted") {
    const Model model = Gltf().read(R"("extensions": {"KHR_materials_sheen": {}, "KHR_materials_clearcoat": {}})",
                                    R"("nodes": [{"mesh": 0}], "extensionsUsed": ["KHR_materials_sheen", "VENDOR_x"])");
    CHECK(left_out_text(model) == "KHR_materials_clearcoat (1 material), KHR_materials_sheen (1 material), VENDOR_x");
}

TEST_CASE("glTF: contents without a material that are left out are named") {
    const auto said = [](const std::string& rest) { return left_out_text(Gltf().read("", rest)); };
    CHECK(said(R"("nodes": [{"mesh": 0}], "animations": [{"channels": [], "samplers": []}, {"channels": [],
        "samplers": []}])") == "further animations (1 animation)");
    Gltf file;
    const auto with = [&](const std::string& primitive) {
        std::string text = head + R"(}], "nodes": [{"mesh": 0}]})";
        const std::string old = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "material": 0})";
        text.replace(text.find(old), old.size(), old + ", " + primitive);
        write_file(file.folder / "more.gltf", text);
        return left_out_text(import_model(file.folder / "more.gltf"));
    };
    CHECK(with(R"({"attributes": {"POSITION": 1}, "mode": 0}, {"attributes": {"POSITION": 1}, "mode": 1})") ==
          "points (1 mesh), lines (1 mesh)");
    CHECK(with(R"({"attributes": {"POSITION": 1, "COLOR_1": 1}})") == "second vertex colours (1 mesh)");
    CHECK(with(R"({"attributes": {"POSITION": 1, "JOINTS_1": 1}})") == "more than four joints a vertex (1 mesh)");
    std::string scenes = head + R"(}], "nodes": [{"mesh": 0}]})";
    scenes.replace(scenes.find(R"([{"nodes": [0]}])"), 16, R"([{"nodes": [0]}, {"nodes": [0]}])");
    write_file(file.folder / "scenes.gltf", scenes);
    CHECK(left_out_text(import_model(file.folder / "scenes.gltf")) == "further scenes");
    CHECK(with(R"({"attributes": {"POSITION": 1}, "targets": [{"POSITION": 1}]})").empty());
    CHECK(with(R"({"attributes": {"POSITION": 1}, "targets": [{"COLOR_0": 1}, {"COLOR_0": 1}]})") ==
          "morph targets of COLOR_0 (1 mesh)");
}

// glTF 2.0, 3.7.2.2: a node's weights take the place of its mesh's.
TEST_CASE("glTF: weights of a mesh and of its node") {
    Gltf file;
    std::string text = head + R"(}], "nodes": [{"mesh": 0, "weights": [0.75]}]})";
    const std::string old = R"({"POSITION": 1}, "material": 0}]})";
    text.replace(text.find(old), old.size(), R"({"POSITION": 1}, "targets": [{"POSITION": 1}]}], "weights": [0.25]})");
    write_file(file.folder / "morph.gltf", text);
    CHECK(import_model(file.folder / "morph.gltf").meshes.at(0).deformation.weights == std::vector<float>{0.75f});
    text.replace(text.find(R"(, "weights": [0.75])"), 19, "");
    write_file(file.folder / "morph.gltf", text);
    CHECK(import_model(file.folder / "morph.gltf").meshes.at(0).deformation.weights == std::vector<float>{0.25f});
}

TEST_CASE("glTF: what is malformed is refused in one line") {
    Gltf file;
    const auto refused = [&](const std::string& rest, const std::string& why) {
        const std::string said = file.error("", rest);
        CAPTURE(rest, said);
        CHECK(said.find(why) != std::string::npos);
    };
    refused(R"("nodes": [{"mesh": 1}])", "meshes 1 is named, there is 1");
    refused(R"("nodes": [{"mesh": "zero"}])", "not as glTF has it");
    refused(R"("nodes": [{"mesh": 0, "children": [0]}])", "node 0 has two parents");
    refused(R"("nodes": [{"mesh": 0}], "extensionsRequired": ["EXT_none"])", "requires the extension EXT_none");
    refused(R"("nodes": [{"mesh": 0}], "animations": [{"channels": [{"sampler": 3, "target": {"node": 0, "path":
        "translation"}}], "samplers": []}])",
            "animation sampler 3 is missing");
    refused(R"("nodes": [{"mesh": 0}], "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path":
        "translation"}}], "samplers": [{"input": 0, "output": 1, "interpolation": "CUBICSPLINE"}]}])",
            "numbers for 2 times");
    CHECK(file.error(R"("normalTexture": {"index": 0})").find("textures 0 is named") != std::string::npos);
}
