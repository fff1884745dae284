// Roles in scene files: contents, messages for each mistake, and the names of files without any role.
#include <filesystem>

#include "catch.h"
#include "scene_fixture.h"

using namespace lightwalk;

namespace {

/// The error for an object with a model and these keys.
std::string error_of_object(const std::string& keys) {
    return error_of("{\"objects\": [\n{\"model\": \"models/cube.obj\", " + keys + "}]}");
}

/// A quad for each material.
Model with_materials(const std::filesystem::path&, const std::vector<std::string>& names) {
    Model model;
    Mesh& mesh = model.meshes.emplace_back(quad_mesh());
    for (const Vertex& v : mesh.vertices) mesh.bounds.add(v.position);
    for (const std::string& name : names) {
        mesh.parts.push_back({0, 6, static_cast<uint32_t>(model.materials.size())});
        model.materials.emplace_back().name = name;
    }
    model.nodes.push_back({.name = "root", .meshes = {0}});
    return model;
}

std::vector<Role> roles_of(SceneFile file, const std::vector<std::string>& materials) {
    Scene scene;
    scene.load(check_device(), std::move(file), [&](const auto& path) { return with_materials(path, materials); });
    std::vector<Role> roles;
    for (const DrawItem& item : scene.items) roles.push_back(item.role);
    return roles;
}

std::vector<Role> roles_in(const std::string& objects, const std::vector<std::string>& materials) {
    return roles_of(parse_scene("{\"objects\": [" + objects + "]}", "s.json"), materials);
}

}  // namespace

TEST_CASE("every mistake in a role names file, line, key and the roles there are") {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {R"("role": "moon")", "scene.json:2: key 'role' is 'moon', expected planet, ring, screen, skin, eye, cornea"},
        {R"("role": "")", "scene.json:2: key 'role' is '', expected planet, ring,"},
        {R"("role": 7)", "scene.json:2: key 'role' must be a role in quotes: planet, ring,"},
        {R"("role": ["planet"])", "scene.json:2: key 'role' must be a role in quotes: planet, ring,"},
        {R"("role": {})", "key 'role' names no material: expected { material: role }"},
        {"\"role\": {\n\"iris\": \"pupil\"}", "scene.json:3: key 'iris' is 'pupil', expected skin, eye, cornea"},
        {R"("role": {"iris": "planet"})", "key 'iris' is 'planet', expected skin, eye, cornea"},
        {R"("role": {"iris": null})", "key 'iris' must be a role in quotes: skin, eye, cornea"},
        {R"("role": "screen")", "scene.json:2: key 'shows' is missing"},
        {R"("role": "screen", "shows": 3)", "key 'shows' must be a text in quotes"},
        {R"("role": "screen", "shows": "nobody")",
         "key 'role' of the screen '' shows 'nobody', which is no object's name"},
        {R"("role": "planet", "shows": "nobody")", "key 'shows' is of an object that is not a screen"},
        {R"("shows": "nobody")", "key 'shows' is of an object that is not a screen"},
    };
    for (const auto& [keys, expected] : mistakes) {
        INFO(keys);
        CHECK_THAT(error_of_object(keys), Catch::Matchers::Contains(expected));
    }
    CHECK_THAT(error_of(R"({"objects": [{"role": "planet"}]})"),
               Catch::Matchers::Contains("key 'role' is of an object without a model"));
}

TEST_CASE("a role for a material that the model lacks is refused when it is loaded, with the materials it has") {
    const SceneFile file = parse_scene(
        "{\"objects\": [\n{\"model\": \"models/cube.obj\",\n\"role\": {\"skin\": \"skin\", \"iris\": \"eye\"}}]}",
        "s.json");
    CHECK_THROWS_WITH(roles_of(file, {"skin", "eyes"}),
                      Catch::Matchers::Contains("s.json:3: key 'role' names 'iris', which is no material of "
                                                "models/cube.obj; it has eyes, skin"));
}

TEST_CASE("an object's role is that of all its parts, one for a material that of those with it") {
    using enum Role;
    const std::string model = "\"model\": \"models/cube.obj\"";
    CHECK(roles_in("{" + model + ", \"role\": \"planet\"}", {"a", "skin"}) == std::vector{planet, planet});
    CHECK(roles_in("{" + model + ", \"role\": {\"a\": \"cornea\", \"b\": \"eye\"}}", {"a", "b", "skin"}) ==
          std::vector{cornea, eye, plain});
}

TEST_CASE("names count where nothing has a role, and only there") {
    using enum Role;
    const auto named = [](const std::string& name, const std::string& more = "") {
        return "{\"name\": \"" + name + "\", \"model\": \"models/cube.obj\"" + more + "}";
    };
    CHECK(roles_in(named("planet"), {""}) == std::vector{planet});
    CHECK(roles_in(named("ring"), {""}) == std::vector{ring});
    CHECK(roles_in(named("screen left"), {""}) == std::vector{screen});
    CHECK(roles_in(named("planets"), {""}) == std::vector{plain});
    CHECK(roles_in(named("head"), {"skin", "eye", "cornea", "planet"}) == std::vector{skin, eye, cornea, plain});
    CHECK(roles_in(named("planet") + ", " + named("ball", ", \"role\": \"ring\""), {"skin"}) ==
          std::vector{plain, ring});

    const SceneFile old = parse_scene("{\"objects\": [" + named("screen left") + "]}", "s.json");
    CHECK(Roles(old).shown_by(0) == "camera left");
    const SceneFile now = parse_scene(
        R"({"objects": [{"name": "door"}, )" + named("screen left", R"(, "role": "screen", "shows": "door")") + "]}",
        "s.json");
    CHECK(Roles(now).shown_by(1) == "door");
    CHECK_FALSE(Roles(now).is_screen(0));
    CHECK(Roles(now).is_screen(1));
}

TEST_CASE("what has a role keeps it when the scene is written") {
    const FileFolder folder;
    const std::filesystem::path path = folder / "roles.json";
    const std::string model = R"("model": "models/cube.obj")";
    write_scene(parse_scene(R"({"objects": [{"name": "door"}, {"name": "a", "role": "screen", "shows": "door", )" +
                                model + R"(}, {"name": "b", "role": {"x": "skin", "y": "eye"}, )" + model +
                                R"(}, {"name": "planet", )" + model + "}]}",
                            "s.json"),
                path);
    const SceneFile again = read_scene(path);
    REQUIRE(again.objects.size() == 4);
    CHECK_FALSE(again.objects[0].role);
    CHECK(again.objects[1].role.object == Role::screen);
    CHECK(again.objects[1].shows == "door");
    CHECK(again.objects[2].role.materials == std::map<std::string, Role>{{"x", Role::skin}, {"y", Role::eye}});
    CHECK_FALSE(again.objects[3].role);
}
