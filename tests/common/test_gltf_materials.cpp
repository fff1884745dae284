// Materials of glTF, and what is named as left out: numbers that follow from the specification.
#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "gltf_fixture.h"

using namespace lightwalk;

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

// The extension's example: the lower left quadrant of the image, rotated clockwise by 90°. (Its GLSL turns the other way;
// see github.com/KhronosGroup/glTF/issues/1563.)
TEST_CASE("glTF: a texture transform turns as the extension's example says") {
    const std::string rest = R"("nodes": [{"mesh": 0}], "textures": [{"source": 0}], "images": [{"uri": "none.png"}])";
    const Material m = Gltf()
                           .read(R"("emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform": {
        "offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]}}})",
                                 rest)
                           .materials[0];
    const MapPlace place = flipped(m.emissive_map.place);  // v from the top
    const auto placed = [&](float u, float v) { return place.turn * glm::vec2(u, v) + place.offset; };
    CHECK(glm::length(placed(0, 0) - glm::vec2(0, 1)) < 1e-6f);
    CHECK(glm::length(placed(1, 0) - glm::vec2(0, 0.5f)) <
          1e-6f);  // upper right of the surface: upper left of the quadrant
    CHECK(glm::length(placed(0, 1) - glm::vec2(0.5f, 1)) < 1e-6f);
    CHECK(glm::length(placed(1, 1) - glm::vec2(0.5f, 0.5f)) < 1e-6f);
}

TEST_CASE("glTF: what is left out is named once, and counted") {
    const Model model = Gltf().read(R"("extensions": {"KHR_materials_sheen": {}, "KHR_materials_clearcoat": {}})",
                                    R"("nodes": [{"mesh": 0}], "extensionsUsed": ["KHR_materials_sheen", "VENDOR_x"])");
    CHECK(left_out_text(model) == "KHR_materials_clearcoat (1 material), KHR_materials_sheen (1 material), VENDOR_x");
}

// glTF 2.0, 3.9.4: OPAQUE ignores every alpha. 3.9.2, 3.9.3: factors and strengths.
TEST_CASE("glTF: numbers of a material") {
    Gltf file;
    CHECK(file.read(R"("pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0]})").materials[0].opacity == 1);
    CHECK(file.read(R"("alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]})")
              .materials[0]
              .opacity == 0.5f);
    const std::string rest = R"("nodes": [{"mesh": 0}], "textures": [{"source": 0}], "images": [{"uri": "none.png"}])";
    const Material m = file.read(R"("pbrMetallicRoughness": {"metallicFactor": 0.25, "roughnessFactor": 0.5,
        "metallicRoughnessTexture": {"index": 0}}, "occlusionTexture": {"index": 0, "strength": 0.75})",
                                 rest)
                           .materials[0];
    CHECK((m.metalness == 0.25f && m.roughness == 0.5f && m.occlusion_strength == 0.75f));
    CHECK((m.metallic_roughness_map && m.occlusion_map && !m.normal_map));
    const Material glossy = file.read(R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor":
        [0.1, 0.2, 0.3, 1], "specularFactor": [0.4, 0.5, 0.6], "glossinessFactor": 0.75}})")
                                .materials[0];
    CHECK((glossy.diffuse == glm::vec3(0.1f, 0.2f, 0.3f) && glossy.specular == glm::vec3(0.4f, 0.5f, 0.6f)));
    CHECK(glossy.roughness == 0.25f);
}

// glTF 2.0, 5.26 (sampler): codes of OpenGL.
TEST_CASE("glTF: samplers") {
    const auto sampler = [](const std::string& words) {
        return Gltf()
            .read(R"("emissiveTexture": {"index": 0})", R"("nodes": [{"mesh": 0}], "images": [{"uri": "none.png"}],
                "textures": [{"source": 0, "sampler": 0}], "samplers": [{)" +
                                                            words + "}]")
            .materials[0]
            .emissive_map.sampler;
    };
    CHECK(sampler("") == Sampler{});
    const Sampler both = sampler(R"("wrapS": 33071, "wrapT": 33648)");
    CHECK((both.wrap == Wrap::clamp && both.wrap_v == Wrap::mirror));
    CHECK(sampler(R"("wrapS": 33648, "wrapT": 33648)").wrap == Wrap::mirror);
    CHECK(sampler(R"("magFilter": 9728)").filter == Filter::nearest);
    CHECK(sampler(R"("minFilter": 9985)").mip_filter == Filter::nearest);
    CHECK(sampler(R"("minFilter": 9729)").max_lod == 0);  // LINEAR: no mips
    CHECK(sampler(R"("minFilter": 9987)").max_lod > 0);
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
