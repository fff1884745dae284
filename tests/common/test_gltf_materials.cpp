// Materials of glTF, and what is named as left out: numbers that follow from the specification.

#include "gltf_fixture.h"

using namespace lightwalk;

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
