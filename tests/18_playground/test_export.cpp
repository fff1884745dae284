// Export to glTF: the file is read back by Assimp, and is written whole or not at all.
#include <nlohmann/json.hpp>

#include "18_playground/gltf.h"
#include "18_playground/playground.h"
#include "common/base/write_files.h"
#include "common/scene/import.h"
#include "editor_fixture.h"

using namespace lightwalk;

TEST_CASE("what is exported to glTF is read back by Assimp: nodes, places, meshes, materials, lights") {
    TestFolder folder;
    Playground chapter;
    chapter.name = "18_playground";
    Gpu& gpu = check_device();
    load_scene(chapter, gpu, "scenes/workbench.json");
    const auto file = folder.path / "out file.gltf";
    export_gltf(chapter.editor.document, chapter.scene, file);
    const Model back = import_model(file);
    std::set<std::string> names;
    for (const Node& node : back.nodes) names.insert(node.name);
    for (const char* name : {"table", "leg 1", "still life", "statue", "camera", "sun", "spot on the statue"})
        CHECK(names.contains(name));
    size_t triangles = 0;
    const std::vector<glm::mat4> worlds = world_transforms(back);
    Bounds box;
    for (size_t i = 0; i < back.nodes.size(); ++i)
        for (const uint32_t mesh : back.nodes[i].meshes) {
            triangles += back.meshes[mesh].indices.size() / 3;
            for (const Vertex& v : back.meshes[mesh].vertices) box.add(glm::vec3(worlds[i] * glm::vec4(v.position, 1)));
        }
    CHECK(triangles == chapter.scene.triangle_count());
    Bounds exact;
    for (const DrawItem& item : chapter.scene.items)
        for (const Vertex& v : item.model->model.meshes[item.mesh].vertices)
            exact.add(glm::vec3(item.transform * glm::vec4(v.position, 1)));
    CHECK(glm::length(box.lower - exact.lower) < 1e-4f);
    CHECK(glm::length(box.upper - exact.upper) < 1e-4f);
    CHECK(read_file(file).find("KHR_lights_punctual") != std::string::npos);
    CHECK_THROWS_AS(export_gltf(chapter.editor.document, chapter.scene, folder.path / "no" / "x.gltf"), InputError);
}

TEST_CASE("what textures cut out is cut out of the export, with the opacity map in the alpha of its colours") {
    const TestFolder folder;
    Image8 holes(8, 4), wood(4, 4);
    for (int i = 0; i < 32; ++i) holes.pixels[size_t(i)] = glm::u8vec4(glm::u8vec3(i % 2 ? 255 : 0), 255);
    for (int i = 0; i < 16; ++i) wood.pixels[size_t(i)] = {10 * i, 100, 200, 255};
    write_png(folder.path / "holes.png", holes), write_png(folder.path / "wood.png", wood);
    std::string text = R"({"knobs": {"maps.cutoff": "0.25"}, "objects": [
        {"model": "models/cube.obj", "material": {"maps": {"diffuse": "@wood.png", "opacity": "@holes.png"}}},
        {"model": "models/sphere.obj", "material": {"maps": {"opacity": "@holes.png"}}},
        {"model": "models/plane.obj", "material": {"maps": {"diffuse": "textures/grass_cutout.png"}}},
        {"model": "models/plane.obj", "material": {"maps": {"diffuse": "textures/wood_albedo.jpg"}}}]})";
    for (size_t at; (at = text.find('@')) != text.npos;) text.replace(at, 1, folder.path.string() + "/");
    write_file(folder.path / "scene.json", text);
    Playground chapter;
    chapter.name = "18_playground";
    load_scene(chapter, check_device(), folder.path / "scene.json");
    const auto file = folder.path / "out.gltf";
    export_gltf(chapter.editor.document, chapter.scene, file);
    std::map<std::string, std::string> modes;  // by texture
    const nlohmann::json gltf = nlohmann::json::parse(read_file(file));
    for (const auto& material : gltf["materials"]) {
        const size_t texture = material["pbrMetallicRoughness"]["baseColorTexture"]["index"];
        const std::string uri = gltf["images"].at(size_t(gltf["textures"].at(texture)["source"]))["uri"];
        modes[std::filesystem::path(uri).filename()] = std::string(material["alphaMode"]);
        CHECK(material.value("alphaCutoff", 0.5f) == (material["alphaMode"] == "MASK" ? 0.25f : 0.5f));
    }
    CHECK(modes == std::map<std::string, std::string>{{"out.cutout1.png", "MASK"},
                                                      {"out.cutout2.png", "MASK"},
                                                      {"grass_cutout.png", "MASK"},
                                                      {"wood_albedo.jpg", "OPAQUE"}});
    int found = 0;
    for (const Material& material : import_model(file).materials) {
        const std::string name = material.diffuse_map.file.filename();
        if (!name.starts_with("out.")) continue;
        const Image8 both = read_image8(material.diffuse_map.file);
        REQUIRE((both.width == 8 && both.height == 4));
        for (size_t i = 0; i < 32; ++i) CHECK(both.pixels[i].a == holes.pixels[i].r);
        CHECK((name == "out.cutout2.png" ? both.at(3, 2) == glm::u8vec4(255) : both.at(3, 2).g == 100));
        ++found;
    }
    CHECK(found == 2);
}

TEST_CASE("an export that cannot be written whole leaves the one before, whole") {
    const TestFolder folder;
    const auto file = folder.path / "a.gltf", buffer = folder.path / "a.bin";
    const auto files = [&](const std::string& text) {
        return std::map<std::filesystem::path, std::string>{{buffer, text}, {file, text}};
    };
    write_files(files("one"));
    CHECK(read_file(buffer) + read_file(file) == "oneone");
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);  // nobody can write that, root included
    CHECK_THROWS_AS(write_files(files("two")), InputError);
    CHECK(read_file(buffer) == "one");
    std::filesystem::remove(file);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
}
