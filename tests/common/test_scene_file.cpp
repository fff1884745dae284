// Scene files: contents, and the line and key reported with each mistake.
#include <filesystem>
#include <fstream>

#include "catch.h"
#include "common/base/text.h"
#include "file_fixture.h"
#include "scene_fixture.h"

using namespace lightwalk;

TEST_CASE("a scene is read, degrees become radians, a parent stands before its children") {
    const SceneFile scene = parse_scene(R"({
        "camera": {"position": [1, 2, 3], "fov_deg": 90},
        "objects": [{"name": "cup", "parent": "table"}, {"name": "table", "scale": 2, "position": [0, 1, 0]}],
        "lights": [{"type": "spot", "inner_deg": 10, "outer_deg": 10, "range_m": 0}],
        "ambient": [0.1, 0.2, 0.3], "knobs": {"method": "phong", "samples": 2, "ambient": true}})",
                                        "s.json");
    CHECK(scene.camera.position == glm::vec3(1, 2, 3));
    CHECK(scene.camera.fov_y_rad == Approx(1.5707963));
    REQUIRE(scene.objects.size() == 2);
    CHECK(scene.objects[0].name == "table");
    CHECK(scene.objects[1].parent == "table");
    CHECK(scene.lights[0].kind == Light::Kind::spot);
    CHECK(scene.lights[0].range_m == 0);
    CHECK(scene.knobs.at("samples") == "2");
    CHECK(scene.knobs.at("ambient") == "on");
}

TEST_CASE("every mistake names file, line and key") {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"{\n\"camera\": {\n\"positon\": [0, 0, 1]}}", "scene.json:3: key 'positon' is unknown here"},
        {"{\n\n\"lights\": [{\"intensity\": \"bright\"}]}", "scene.json:3: key 'intensity' must be a number"},
        {"{\"lights\": [\n{\"intensity\": -1}]}", "scene.json:2: key 'intensity' is -1, expected 0.0 to 1000000.0"},
        {"{\"lights\": [{\"intensity\": 1e300}]}", "key 'intensity' is 1e+300"},
        {"{\"lights\": [{\"type\": \"sun\"}]}", "expected directional, point or spot"},
        {"{\"lights\": [{\"type\": \"spot\", \"inner_deg\": 20, \"outer_deg\": 10}]}",
         "key 'inner_deg' is above outer_deg"},
        {"{\"objects\": [{\"scale\": 0}]}", "nothing would be left"},
        {"{\"objects\": [{\"model\": \"models/absent.obj\"}]}", "scene.json:1: key 'model': no file models/absent.obj"},
        {"{\"objects\": {}}", "key 'objects' must be a list"},
        {"{\"camera\": {\"target\": [0, 0]}}", "must be three numbers"},
        {"{\"camera\": {\"position\": [0,0,0], \"target\": [0,0,0]}}", "it would look nowhere"},
        {"{\"objects\": [{\"name\": \"a\", \"parent\": \"b\"}, {\"name\": \"b\", \"parent\": \"a\"}]}",
         "a cycle of parents among a, b"},
        {"{\"objects\": [{\"parent\": \"gone\"}]}", "parent 'gone' is no object's name"},
        {"{\"objects\": [{\"name\": \"a\"}, {\"name\": \"a\"}]}", "two objects are named 'a'"},
        {"{\n\"ambient\": [0, 0, 0],\n\"ambient\": [1, 1, 1]}", "scene.json:3: key 'ambient' stands twice"},
        {R"({"environment": 7})", "scene.json:1: key 'environment' must be an object"},
        {R"({"environment": {"intensity": 2}})", "key 'image' is missing"},
        {R"({"environment": "models/cube.obj"})",
         "key 'environment' is 'models/cube.obj', expected an .hdr or .pfm file"},
        {R"({"environment": "hdr/none.hdr"})", "key 'environment': no file hdr/none.hdr"},
        {"{\n\"environment\": {\n\"image\": \"hdr/none.hdr\"}}", "scene.json:3: key 'image': no file hdr/none.hdr"},
        {R"({"environment": {"image": "x.hdr", "intensity": -1}})", "key 'intensity' is -1, expected 0.0 to 1000000.0"},
        {R"({"environment": {"image": "x.hdr", "rotation_deg": "north"}})", "key 'rotation_deg' must be a number"},
        {R"({"environment": {"image": "x.hdr", "exposure": 1}})",
         "key 'exposure' is unknown here; known: image, intensity"},
        {"{\n\"camera\": }", "scene.json:2: not JSON"},
        {"", "not JSON"},
        {"[]", "must be an object"},
        {std::string(1000, '['), "nested too deep"},
    };
    for (const auto& [text, expected] : mistakes) {
        INFO(text);
        CHECK_THAT(error_of(text), Catch::Matchers::Contains(expected));
    }
}

TEST_CASE("every mistake in a motion names file, line and key") {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"{}", "key 'motion' says neither spin_deg_per_s nor path"},
        {"[]", "key 'motion' must be an object"},
        {"{\n\"spin\": 3}", "scene.json:2: key 'spin' is unknown here; known: axis, path, period_s, spin_deg_per_s"},
        {R"({"spin_deg_per_s": "fast"})", "key 'spin_deg_per_s' must be a number"},
        {R"({"spin_deg_per_s": 1e300})", "key 'spin_deg_per_s' is 1e+300"},
        {R"({"spin_deg_per_s": 1, "axis": [0, 0, 0]})", "key 'axis' has no length"},
        {R"({"spin_deg_per_s": NaN})", "not JSON"},
        {R"({"path": []})", "key 'path' is empty"},
        {R"({"path": {}})", "key 'path' must be a list"},
        {R"({"path": [7]})", "key '0' must be an object"},
        {R"({"path": [{"position": [0, 0, 0]}]})", "key 'time_s' is missing"},
        {R"({"path": [{"time_s": null}]})", "key 'time_s' must be a number"},
        {"{\"path\": [{\"time_s\": 0},\n{\"time_s\": 0}]}", "scene.json:2: key 'time_s' must be above the one before"},
        {R"({"path": [{"time_s": 1}, {"time_s": 0}]})", "key 'time_s' must be above the one before"},
        {R"({"path": [{"time_s": 1, "where": [0, 0, 0]}]})", "key 'where' is unknown here"},
        {R"({"path": [{"time_s": 1, "scale": 0}]})", "key 'scale' is 0"},
        {R"({"path": [{"time_s": 1}, {"time_s": 2, "scale": [1, -1, 1]}]})", "key 'scale' has another sign"},
        {R"({"path": [{"time_s": 1}, {"time_s": 2}], "period_s": 1})", "key 'period_s' must be above the time"},
        {R"({"path": [{"time_s": 1}], "period_s": -1})", "key 'period_s' is -1"},
        {R"({"spin_deg_per_s": 1, "period_s": 1})", "key 'period_s' closes a path, and there is none"},
    };
    for (const auto& [text, expected] : mistakes) {
        INFO(text);
        CHECK_THAT(error_of("{\"objects\": [{\"motion\": " + text + "}]}"), Catch::Matchers::Contains(expected));
    }
}

TEST_CASE("a keyframe that leaves something out has the object's own") {
    const SceneFile scene = parse_scene(R"({"objects": [{"position": [1, 2, 3], "scale": -2, "rotation_deg": [4, 5, 6],
        "motion": {"path": [{"time_s": 0}, {"time_s": 1, "position": [7, 8, 9], "scale": [-1, -2, -3]}]}}]})",
                                        "s.json");
    const std::vector<Keyframe>& path = scene.objects[0].motion.path;
    CHECK(path[0] == Keyframe{0, {1, 2, 3}, {4, 5, 6}, {-2, -2, -2}});
    CHECK(path[1] == Keyframe{1, {7, 8, 9}, {4, 5, 6}, {-1, -2, -3}});
}

TEST_CASE("several includes: lights and objects of all are kept in their order, of other keys what was said last") {
    const FileFolder folder;
    const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
    write("room.json", R"({"lights": [{"intensity": 1}, {"intensity": 2}], "objects": [{"name": "a"}],
                           "camera": {"fov_deg": 90}, "background": [1, 0, 0], "knobs": {"samples": 2, "wrap": 1}})");
    write("sky.json", R"({"lights": [{"intensity": 3}], "objects": [{"name": "b"}], "background": [0, 1, 0],
                          "knobs": {"samples": 3}})");
    write("all.json",
          R"({"include": ["room.json", "sky.json"], "lights": [{"intensity": 4}], "objects": [{"name": "c"}]})");
    const SceneFile scene = read_scene(folder / "all.json");
    REQUIRE(scene.lights.size() == 4);
    for (size_t i = 0; i < 4; ++i) CHECK(scene.lights[i].intensity == float(i + 1));
    REQUIRE(scene.objects.size() == 3);
    for (size_t i = 0; i < 3; ++i) CHECK(scene.objects[i].name == std::string(1, char('a' + i)));
    CHECK(scene.camera.fov_y_rad == Approx(1.5707963));
    CHECK(scene.background == glm::vec3(0, 1, 0));
    CHECK(scene.knobs == std::map<std::string, std::string>{{"samples", "3"}, {"wrap", "1"}});
}

TEST_CASE("a cycle of includes is named, and a chain without one is read") {
    const FileFolder folder;
    const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
    write("a.json", R"({"include": ["b.json"], "ambient": [1, 1, 1]})");
    write("b.json", R"({"lights": [{}], "ambient": [0, 0, 0]})");
    write("c.json", R"({"include": ["d.json"]})");
    write("d.json", R"({"include": ["c.json"]})");
    const SceneFile scene = read_scene(folder / "a.json");
    CHECK(scene.lights.size() == 1);
    CHECK(scene.ambient == glm::vec3(1.0f));
    CHECK_THROWS_WITH(read_scene(folder / "c.json"), Catch::Matchers::Contains("a cycle of includes"));
}

TEST_CASE("what is written is read back the same") {
    const FileFolder folder;
    SceneFile scene = parse_scene(R"({
        "camera": {"position": [0.1, 0.2, 0.3], "fov_deg": 41},
        "objects": [{"name": "a", "model": "models/cube.obj", "rotation_deg": [10, 20, 30],
                     "material": {"diffuse": [0.1, 0.2, 0.3], "shininess": 7, "blend": true},
                     "motion": {"spin_deg_per_s": 20, "axis": [1, 1, 0], "period_s": 9,
                                "path": [{"time_s": 1}, {"time_s": 2.5, "position": [1, 2, 3], "scale": 2}]}}],
        "lights": [{"type": "point", "position": [1, 2, 3], "range_m": 4, "intensity": 5,
                    "shadow": true, "size_m": 0.25, "tube_m": [0.5, 0, 2]}, {"shadow": true, "size_deg": 0.53}],
        "knobs": {"samples": 3}})",
                                  "s.json");
    write_file(folder / "sky.hdr", "read when the scene is loaded");
    scene.environment = {.image = folder / "sky.hdr", .intensity = 2.5f, .rotation_deg = -30};
    write_scene(scene, folder / "s.json");
    const SceneFile again = read_scene(folder / "s.json");
    CHECK(again.camera.position == scene.camera.position);
    CHECK(again.camera.fov_y_rad == Approx(scene.camera.fov_y_rad));
    CHECK(again.objects[0].rotation_deg == scene.objects[0].rotation_deg);
    CHECK(*again.objects[0].material.diffuse == *scene.objects[0].material.diffuse);
    CHECK(again.lights[0] == scene.lights[0]);
    CHECK(again.lights[0].size_m == 0.25f);
    CHECK(again.lights[1].shadow);
    CHECK(again.lights[1].size_rad == Approx(0.00925).margin(1e-5));
    CHECK(again.objects[0].motion == scene.objects[0].motion);
    CHECK(again.objects[0].material.blend == true);
    CHECK(again.environment.image == scene.environment.image);
    CHECK(again.environment.intensity == 2.5f);
    CHECK(again.environment.rotation_deg == -30);
    CHECK(again.knobs == scene.knobs);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 2);
}

TEST_CASE("the scene corpus never does worse than an InputError") {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(course_root() / "tests/common/corpus/scene")) {
        ++files;
        try {
            parse_scene(read_file(entry.path()), entry.path());
        } catch (const InputError&) {}
    }
    CHECK(files >= 8);
}

TEST_CASE("rotations go about x, then y, then z") {
    SceneObject object;
    object.rotation_deg = {90, 90, 0};
    const glm::vec3 turned = glm::vec3(local_transform(object) * glm::vec4(0, 1, 0, 0));
    CHECK(glm::length(turned - glm::vec3(1, 0, 0)) < 1e-6f);  // y to z about x, z to x about y
}

TEST_CASE("limits: nested lists, nested includes, includes without number, long chains of parents") {
    CHECK(error_of("{\"objects\": " + std::string(100000, '[')).find("nested too deep") != std::string::npos);
    // A key of 1 MB around a million values: their pointers would take 1 TB.
    std::string bomb = "{\"" + std::string(1000000, 'k') + "\": [";
    for (int i = 0; i < 1000000; ++i) bomb += "{},";
    CHECK(error_of(bomb + "{}]}").find("too large") != std::string::npos);
    // A / in a key is no level of its own, and a key that is wrong is shown as it stands.
    CHECK(error_of("{\"knobs\": {\"a/b\": 1, \"a\": 2}, \"knobs/a\": 1}").find("'knobs/a' is unknown") !=
          std::string::npos);
    CHECK(error_of("{\"a~1b\": 1, \"a/b\": 1}").find("twice") == std::string::npos);

    const FileFolder folder;
    const auto refused = [&](const char* name) { return refusal_of([&] { read_scene(folder / name); }); };
    for (int i = 0; i < 100; ++i)
        write_file(folder / fmt::format("deep{}.json", i), fmt::format("{{\"include\": [\"deep{}.json\"]}}", i + 1));
    CHECK(refused("deep0.json").find("more than 32 deep: deep0.json includes deep1.json includes") !=
          std::string::npos);
    for (int i = 0; i < 30; ++i)
        write_file(folder / fmt::format("twice{}.json", i),
                   fmt::format("{{\"include\": [\"twice{0}.json\", \"twice{0}.json\"]}}", i + 1));
    write_file(folder / "twice30.json", "{}");
    CHECK(refused("twice0.json").find("more than 256 includes in all") != std::string::npos);
    CHECK(refused("twice25.json").empty());

    std::string chain = "{\"objects\": [";
    for (int i = 0; i < 20000; ++i) chain += fmt::format("{{\"name\": \"{}\", \"parent\": \"{}\"}},", i, i + 1);
    const SceneFile scene = parse_scene(chain + "{\"name\": \"20000\"}]}", "/nonexistent/test.json");
    REQUIRE(scene.objects.size() == 20001);
    CHECK(scene.objects.front().name == "20000");
    CHECK(scene.objects.back().name == "0");
}

TEST_CASE("what a drawing that stands for a file leaves out of its objects is named, and what is hidden is not shown",
          "[common.unused_placement]") {
    const auto is_ground = [](const std::filesystem::path& file) { return file.extension() == ".png"; };
    const auto said = [&](std::vector<SceneObject> objects) {
        SceneFile scene;
        scene.file = "s.json";
        scene.objects = std::move(objects);
        std::string words;
        collected_warnings() = &words;
        name_unused_placement(scene, is_ground, "a terrain");
        collected_warnings() = nullptr;
        const SceneObject* const shown = first_shown(scene, is_ground);
        return std::pair(shown ? shown->name : "", words);
    };
    const SceneObject plain{.name = "a", .model = "a.png"}, other{.name = "b", .model = "b.png"};
    SceneObject moved = plain, hidden = plain, group{.name = "g"}, child = other;
    moved.position.x = 1;
    moved.scale.y = 2;
    hidden.hidden = true;
    group.rotation_deg.y = 90;
    child.parent = "g";
    CHECK(said({plain}) == std::pair<std::string, std::string>("a", ""));
    CHECK(has_part(said({moved}).second, "s.json: 'a': left out: position, scale of a terrain"));
    CHECK(has_part(said({plain, other}).second, "s.json: 'b': left out: of a terrain the first is drawn, 'a'"));
    CHECK(said({hidden, other}) == std::pair<std::string, std::string>("b", ""));
    CHECK(said({hidden}).first.empty());
    CHECK(has_part(said({group, child}).second, "s.json: 'g': left out: rotation_deg of a terrain"));
    group.hidden = true;
    CHECK(said({group, child}) == std::pair<std::string, std::string>("", ""));
}
