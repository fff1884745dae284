// glTF as the specification has it: numbers that follow from its text, and files that must be refused.
#include <unistd.h>

#include <glm/gtc/constants.hpp>

#include "common/base/error.h"
#include "scene_fixture.h"

using namespace lightwalk;

namespace {

// Two floats 0 and 1, then three positions: (0, 0, 0), (1, 0, 0), (0, 1, 0).
const std::string head = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "buffers": [{"byteLength": 44,
    "uri": "data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
    "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "material": 0}]}], "materials": [{)";

struct Gltf {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("lightwalk_gltf_{}", getpid());
    Gltf() { std::filesystem::create_directories(folder); }
    ~Gltf() { std::filesystem::remove_all(folder); }
    Model read(const std::string& material, const std::string& rest = R"("nodes": [{"mesh": 0}])") {
        const auto file = folder / "model.gltf";
        write_file(file, head + material + "}], " + rest + "}");
        return import_model(file);
    }
    std::string error(const std::string& material, const std::string& rest = R"("nodes": [{"mesh": 0}])") {
        try {
            read(material, rest);
        } catch (const InputError& e) {
            CHECK(std::string(e.what()).find('\n') == std::string::npos);
            return e.what();
        }
        return "";
    }
};

}  // namespace

TEST_CASE("glTF: what a material that says nothing is") {
    const Material m = Gltf().read("").materials[0];
    CHECK(m.diffuse == glm::vec3(1));
    CHECK(m.metalness == 1);
    CHECK(m.roughness == 1);
    CHECK(m.alpha_cutoff == 0);
    CHECK(m.sides == Sides::front);
    CHECK(m.emissive == glm::vec3(0));
    CHECK((m.metallic_roughness && m.microfacets && !m.unlit && !m.blend));
}

TEST_CASE("glTF: alpha modes, sides, unlit, emissive strength") {
    Gltf file;
    CHECK(file.read(R"("alphaMode": "MASK")").materials[0].alpha_cutoff == 0.5f);
    CHECK(file.read(R"("alphaMode": "MASK", "alphaCutoff": 0.1)").materials[0].alpha_cutoff == 0.1f);
    CHECK(file.read(R"("alphaMode": "BLEND")").materials[0].blend);
    CHECK(file.read(R"("doubleSided": true)").materials[0].sides == Sides::both);
    CHECK(file.read(R"("extensions": {"KHR_materials_unlit": {}})").materials[0].unlit);
    const Material m = file.read(R"("emissiveFactor": [1, 0.5, 0],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 3}})")
                           .materials[0];
    CHECK(m.emissive == glm::vec3(3, 1.5f, 0));
}

// The extension's own matrix, with v growing downwards: offset · rotation · scale.
TEST_CASE("glTF: a texture transform in coordinates whose v grows upwards") {
    const std::string rest = R"("nodes": [{"mesh": 0}], "textures": [{"source": 0}], "images": [{"uri": "none.png"}])";
    const Material m = Gltf()
                           .read(R"("normalTexture": {"index": 0, "texCoord": 1, "scale": 0.25, "extensions":
        {"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2, 4]}}})",
                                 rest)
                           .materials[0];
    const MapPlace& place = m.normal_map.place;
    CHECK(place.set == 1);
    CHECK(m.normal_scale == 0.25f);
    const auto placed = [&](float u, float v) { return place.turn * glm::vec2(u, v) + place.offset; };
    CHECK(glm::length(placed(0, 1) - glm::vec2(0.5f, 0.75f)) < 1e-6f);   // (0, 0) there: (0.5, 0.25)
    CHECK(glm::length(placed(1, 0) - glm::vec2(2.5f, -3.25f)) < 1e-6f);  // (1, 1) there: (2.5, 4.25)
    CHECK(flipped(flipped(place)).offset == place.offset);
}

TEST_CASE("glTF: lights in lux and candela, cameras by node") {
    const Model model = Gltf().read("", R"("nodes": [{"mesh": 0, "children": [1, 2]}, {"camera": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1.2, "znear": 0.5}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 10, "color": [1, 0.5, 0],
        "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}]}})");
    REQUIRE((model.cameras.size() == 1 && model.lights.size() == 1));
    CHECK(model.cameras[0].camera.fov_y_rad == 1.2f);
    CHECK(model.nodes[model.cameras[0].node].parent == 0);
    const Light& light = model.lights[0].light;
    CHECK(light.kind == Light::Kind::spot);
    CHECK(std::abs(light.intensity - 10 / glm::pi<float>()) < 1e-5f);  // the radiance of white: E / pi
    CHECK((light.inner_rad == 0.1f && light.outer_rad == 0.2f));
}

// glTF 2.0, appendix C: at a quarter of the way, with values 0 and 1 at 0 s and 1 s.
TEST_CASE("glTF: interpolation") {
    KeyTrack<glm::vec3> track = {{0, glm::vec3(0)}, {1, glm::vec3(1)}};
    Model model;
    model.nodes.emplace_back();
    model.motions_s = 2;
    const auto at = [&](Between between) {
        track.between = between;
        track.slopes = {glm::vec3(0), glm::vec3(2), glm::vec3(0), glm::vec3(0)};
        model.motions = {{.position = track, .scale = {{0, glm::vec3(1)}}, .rotation = {{0, glm::quat(1, 0, 0, 0)}}}};
        return world_transforms(model, 0.25f)[0][3].x;
    };
    CHECK(at(Between::linear) == 0.25f);
    CHECK(at(Between::step) == 0);
    // (-2t³ + 3t²) · 1 + (t³ - 2t² + t) · 2 at t = 1/4: 0.15625 + 0.28125
    CHECK(std::abs(at(Between::cubic) - 0.4375f) < 1e-6f);
}

TEST_CASE("glTF: what is left out is named once, and counted") {
    const Model model = Gltf().read(R"("extensions": {"KHR_materials_sheen": {}, "KHR_materials_clearcoat": {}})",
                                    R"("nodes": [{"mesh": 0}], "extensionsUsed": ["KHR_materials_sheen", "VENDOR_x"])");
    CHECK(left_out_text(model) == "KHR_materials_clearcoat (1 material), KHR_materials_sheen (1 material), VENDOR_x");
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
