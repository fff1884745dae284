// Export to glTF: the file is read back by Assimp, and is written whole or not at all.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <glm/gtc/constants.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "18_playground/gltf.h"
#include "18_playground/playground.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/own_files.h"
#include "common/scene/import.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

void check_lights_and_camera(const SceneFile& scene, const Model& back) {
    const auto worlds = world_transforms(back);
    REQUIRE((back.cameras.size() == 1 && back.lights.size() == scene.lights.size()));
    const auto ahead = [&](uint32_t node) { return -glm::vec3(worlds[node][2]); };
    const FileCamera& camera = back.cameras[0];
    const glm::vec3 to_target = glm::normalize(scene.camera.target - scene.camera.position);
    CHECK(glm::length(glm::vec3(worlds[camera.node][3]) - scene.camera.position) < 1e-5f);
    CHECK(glm::length(ahead(camera.node) - to_target) < 1e-5f);
    const glm::vec3 right = glm::normalize(glm::cross(to_target, scene.camera.up));  // the camera's roll
    CHECK(glm::length(glm::vec3(worlds[camera.node][0]) - right) < 1e-5f);
    CHECK(std::abs(camera.camera.fov_y_rad - scene.camera.fov_y_rad) < 1e-6f);
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &one = scene.lights[i], &other = back.lights[i].light;
        CHECK(one.kind == other.kind);
        CHECK(one.color == other.color);
        CHECK(std::abs(one.intensity - other.intensity) < 1e-5f * one.intensity);
        if (one.kind != Light::Kind::point)
            CHECK(glm::length(ahead(back.lights[i].node) - glm::normalize(one.direction)) < 1e-5f);
        if (one.kind == Light::Kind::directional) continue;
        CHECK(glm::vec3(worlds[back.lights[i].node][3]) == one.position);
        CHECK(one.range_m == other.range_m);
        if (one.kind == Light::Kind::spot)
            CHECK((one.inner_rad == other.inner_rad && one.outer_rad == other.outer_rad));
    }
}

size_t triangle_count(const Model& model) {
    size_t count = 0;
    for (const Node& node : model.nodes)
        for (const uint32_t mesh : node.meshes) count += model.meshes[mesh].indices.size() / 3;
    return count;
}

// Meshes at several nodes count at each.
size_t triangle_count(const aiScene& scene, const aiNode& node) {
    size_t count = 0;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) count += scene.mMeshes[node.mMeshes[i]]->mNumFaces;
    for (unsigned i = 0; i < node.mNumChildren; ++i) count += triangle_count(scene, *node.mChildren[i]);
    return count;
}

}  // namespace

// For test_round_trip.py: scenes of standard input, one a line, each to out.gltf beside it.
TEST_CASE("scenes are exported, and read back by Assimp and by our own reader", "[.exported]") {
    for (std::string file; std::getline(std::cin, file);) {
        CAPTURE(file);
        const auto out = std::filesystem::path(file).replace_filename("out.gltf");
        Playground chapter;
        chapter.name = "18_playground";
        load_scene(chapter, check_device(), file);
        export_gltf(chapter.editor.document, chapter.scene, out);
        const Model back = import_model(out);
        CHECK(triangle_count(back) == chapter.scene.triangle_count());
        check_lights_and_camera(chapter.scene.file, back);
        Assimp::Importer importer;
        const aiScene* const other = importer.ReadFile(out.string(), aiProcess_Triangulate);
        CAPTURE(importer.GetErrorString());
        REQUIRE(other);
        CHECK(triangle_count(*other, *other->mRootNode) == chapter.scene.triangle_count());
        CHECK(other->mNumLights == chapter.scene.file.lights.size());
        CHECK(other->mNumCameras == 1);
    }
}

namespace {

// A scene in a folder of its own.
struct Opened {
    const FileFolder folder;
    Playground chapter;
    explicit Opened(const std::string& scene) {
        chapter.name = "18_playground";
        write_file(folder / "scene.json", scene);
        load_scene(chapter, check_device(), folder / "scene.json");
    }
    Model exported() {
        export_gltf(chapter.editor.document, chapter.scene, folder / "out.gltf");
        return import_model(folder / "out.gltf");
    }
};

Image8 picture_of_scene(Playground& chapter, Gpu& gpu) {
    Frame frame(gpu);
    render(chapter, frame, {.size = {160, 90}, .crop = {}});
    return read_picture(gpu, chapter.written(frame));
}

int most_steps(const Image8& a, const Image8& b) {
    int most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a.pixels[i][c]) - int(b.pixels[i][c])));
    return most;
}

}  // namespace

TEST_CASE("a scene that is saved from a bare model keeps its ground, and the model that stands on it may move") {
    FileFolder folder;
    Gpu& gpu = check_device();
    Playground chapter, again;
    for (Playground* one : {&chapter, &again}) one->name = "18_playground";
    load_scene(chapter, gpu, "conformance/flat_normals.gltf");
    const Image8 before = picture_of_scene(chapter, gpu);
    Document& document = chapter.editor.document;
    chapter.editor.store.save_as(document, folder.path / "saved.json");
    load_scene(again, gpu, folder.path / "saved.json");
    CHECK(again.scene.items.size() == chapter.scene.items.size());
    CHECK(most_steps(before, picture_of_scene(again, gpu)) <= 1);

    document.begin("move");
    for (const EntryId id : with_children(document, root_entry))
        if (document.at(id).object() && !document.at(id).object()->ground) document.edit(id).object()->position.y = 1;
    document.commit();
    chapter.editor.live.update(gpu, document, chapter.scene, {});
    const Image8 moved = picture_of_scene(chapter, gpu);
    CHECK(most_steps(before, moved) > 8);
    chapter.editor.store.save(document);
    load_scene(again, gpu, folder.path / "saved.json");
    CHECK(most_steps(moved, picture_of_scene(again, gpu)) <= 1);
}

TEST_CASE("glass is exported as thin transmission, and its tint beside a body as a volume's attenuation") {
    const Model back = Opened(R"({"objects": [{"model": "models/cube.obj", "material":
        {"opacity": 0, "transmission": [0.9, 0.5, 0.125], "diffuse": [0.1, 0.1, 0.1], "roughness": 0.5, "metalness": 0}},
        {"model": "models/cube.obj", "material":
        {"opacity": 0.25, "transmission": [0.25, 0.1, 0], "diffuse": [0.5, 0.2, 0.4], "roughness": 0.5, "metalness": 0}}]})")
                           .exported();
    CHECK(back.materials.at(0).opacity == 0);
    CHECK(glm::length(back.materials[0].transmission - glm::vec3(0.9f, 0.5f, 0.125f)) < 1e-6f);
    CHECK((back.materials.at(1).opacity == 0.25f && back.materials[1].diffuse == glm::vec3(0.5f, 0.2f, 0.4f)));
    CHECK(glm::length(back.materials[1].transmission - glm::vec3(0.25f, 0.1f, 0)) < 1e-6f);
}

// glTF 2.0, 3.9.2: metalness and roughness are the texture's channels times the factors. The object's numbers replace the map's.
TEST_CASE("a map of occlusion, roughness and metalness is exported with its factors, glass beside it as glass") {
    const FileFolder folder;
    write_png(folder.path / "orm.png", Image8(4, 4, {255, 128, 0, 255}));
    const std::string map = R"("maps": {"orm": ")" + (folder.path / "orm.png").string() + "\"}";
    const std::string cube = R"({"model": "models/cube.obj", "material": {)";
    write_file(folder.path / "scene.json",
               R"({"objects": [)" + cube +
                   R"("opacity": 0.25, "diffuse": [0.5, 0.25, 1], "transmission": [0.5, 0.25, 1], )" + map + "}}," +
                   cube + map + "}}," + cube + R"("metalness": 0.5, "roughness": 0.25, )" + map + "}}," + cube +
                   R"("metalness": 0, )" + map + "}}]}");
    Playground chapter;
    chapter.name = "18_playground";
    load_scene(chapter, check_device(), folder.path / "scene.json");
    export_gltf(chapter.editor.document, chapter.scene, folder.path / "out.gltf");
    const Model back = import_model(folder.path / "out.gltf");
    const auto numbers = [&](size_t i) {
        const Material& m = back.materials.at(i);
        CHECK(m.occlusion_map);
        return std::tuple(m.metalness, m.roughness, bool(m.metallic_roughness_map));
    };
    CHECK(numbers(0) == std::tuple(1.0f, 1.0f, true));
    CHECK(back.materials[0].opacity == 0.25f);
    CHECK(glm::length(back.materials[0].transmission - glm::vec3(0.5f, 0.25f, 1)) < 1e-6f);
    CHECK(numbers(1) == std::tuple(1.0f, 1.0f, true));
    CHECK(numbers(2) == std::tuple(0.5f, 0.25f, false));
    CHECK(numbers(3) == std::tuple(0.0f, 1.0f, true));
}

// B. Karis, "Specular BRDF reference", 2013: an exponent is 2 / alpha² - 2, alpha the square of roughness.
TEST_CASE("an exponent of 30 is exported as a roughness of a half") {
    Opened opened(R"({"objects": [{"model": "models/cube.obj", "material": {"shininess": 30}}]})");
    CHECK(opened.exported().materials.at(0).roughness == Approx(0.5f));
}

TEST_CASE("what textures cut out is cut out of the export, with the opacity map in the alpha of its colours") {
    const FileFolder folder;
    Image8 holes(8, 4), wood(4, 4);
    for (int i = 0; i < 32; ++i) holes.pixels[size_t(i)] = glm::u8vec4(glm::u8vec3(i % 2 ? 255 : 0), 255);
    for (int i = 0; i < 16; ++i) wood.pixels[size_t(i)] = {10 * i, 100, 200, 255};
    write_png(folder.path / "holes.png", holes);
    write_png(folder.path / "wood.png", wood);
    std::string text = R"({"knobs": {"maps.cutoff": "0.25"}, "objects": [
        {"model": "models/cube.obj", "material": {"maps": {"diffuse": "@wood.png", "opacity": "@holes.png"}}},
        {"model": "models/sphere.obj", "material": {"maps": {"opacity": "@holes.png"}}},
        {"model": "models/plane.obj", "material": {"maps": {"diffuse": "textures/grass_cutout.png"}}},
        {"model": "models/plane.obj", "material": {"maps": {"diffuse": "textures/wood_albedo.jpg"}}}]})";
    for (size_t at; (at = text.find('@')) != text.npos;) text.replace(at, 1, folder.path.string() + "/");
    Opened opened(text);
    const Model back = opened.exported();
    std::map<std::string, std::string> modes;  // by texture
    const nlohmann::json gltf = nlohmann::json::parse(read_file(opened.folder / "out.gltf"));
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
    for (const Material& material : back.materials) {
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
    const FileFolder folder;
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

TEST_CASE("cameras and lights of a model's file are offered where its object stands", "[18.offers]") {
    Opened opened(R"({"objects": [{"name": "lit", "model": "conformance/own_light.gltf", "position": [1, 0, 0]}]})");
    Document& document = opened.chapter.editor.document;
    const EntryId lit = document.at(root_entry).children.at(0);
    const Editor::Offered file = opened.chapter.editor.offered(opened.chapter.scene, lit);
    REQUIRE((file.cameras.size() == 1 && file.lights.size() == 1));
    const Camera& camera = file.cameras[0].second;  // the file's node stands at (0, 0, 2) and is not turned
    CHECK(camera.position == glm::vec3(1, 0, 2));
    CHECK(glm::normalize(camera.target - camera.position) == glm::vec3(0, 0, -1));
    CHECK(file.lights[0].color == glm::vec3(1, 0, 0));
    CHECK(std::abs(file.lights[0].intensity - 1.5f / glm::pi<float>()) < 1e-6f);
    const auto ids = add_lights(document, "add", file.lights);
    CHECK(document.at(ids.at(0)).light()->direction == glm::vec3(0, 0, -1));
    CHECK(document.undo());
    CHECK_FALSE(document.find(ids[0]));
}

TEST_CASE("a bare model is saved with its exposure", "[18.bare]") {
    const FileFolder folder;
    SceneFile scene;
    scene.bare = true;
    scene.emission = 0.25f;
    scene.objects.push_back(named("square", "conformance/own_light.gltf"));
    SceneStore store;
    store.open_empty();
    store.save_as(Document(scene), folder.path / "saved.json");
    const SceneFile back = read_scene(folder.path / "saved.json");
    CHECK((back.bare && back.emission == 0.25f));
    CHECK(store.open(folder.path / "saved.json").settings().bare);
}
