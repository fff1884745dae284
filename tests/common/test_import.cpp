// Other formats through Assimp: transforms in the right order, and bad files refused.
#include <sys/stat.h>

#include "common/base/files.h"
#include "common/scene/asset_path.h"
#include "common/scene/import.h"
#include "file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

fs::path data(const char* name) { return course_root() / "tests/common/data" / name; }

// Where each node that has the mesh puts the vertex that lies at `point` in the mesh.
std::vector<glm::vec3> placed(const Model& model, glm::vec3 point) {
    const auto world = world_transforms(model);
    std::vector<glm::vec3> places;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        for (size_t k = 0; k < model.nodes[i].meshes.size(); ++k)
            places.push_back(glm::vec3(world[i] * glm::vec4(point, 1.0f)));
    return places;
}

bool near(glm::vec3 a, glm::vec3 b) { return glm::length(a - b) < 1e-5f; }

}  // namespace

TEST_CASE("a model is known by the end of its name, in any capitals") {
    for (const char* name : {"a.gltf", "A.3MF", "b/c.Off", "d.obj"}) CHECK(is_model_file(name));
    for (const char* name : {"a.png", "obj", "a.obj.json", ""}) CHECK_FALSE(is_model_file(name));
}

TEST_CASE("import: nested nodes, and one mesh under two of them") {
    for (const char* file : {"nested.gltf", "nested.dae"}) {
        CAPTURE(file);
        const Model model = import_model(data(file));
        REQUIRE(model.meshes.size() == 1);
        CHECK(model.meshes[0].vertices.size() == 3);
        CHECK(model.meshes[0].indices.size() == 3);
        for (const Vertex& v : model.meshes[0].vertices) CHECK(near(v.normal, {0, 0, 1}));  // the file gives none
        for (size_t i = 0; i < model.nodes.size(); ++i) CHECK(model.nodes[i].parent < static_cast<int>(i));
        // leaf: moved by (0, 0, 5), scaled by (2, 3, 4), turned by 90 degrees about z (x to y, y to -x), moved by 10 in
        // x. other: halved, then moved by (10, -1, 0).
        const auto x = placed(model, {1, 0, 0}), y = placed(model, {0, 1, 0});
        REQUIRE(x.size() == 2);
        CHECK(near(x[0], {10, 2, 20}));
        CHECK(near(y[0], {7, 0, 20}));
        CHECK(near(x[1], {10.5f, -1, 0}));
        CHECK(near(y[1], {10, -0.5f, 0}));
        const Bounds bounds = model_bounds(model);
        CHECK(near(bounds.lower, {7, -1, 0}));
        CHECK(near(bounds.upper, {10.5f, 2, 20}));
    }
}

TEST_CASE("import: files on which Assimp 5.2.5 dies cost no more than an error") {
    for (const char* name : {"assimp_aborts.ply", "assimp_crashes.ply"}) {
        CAPTURE(name);
        try {
            import_model(data(name));  // a later Assimp may read them
        } catch (const InputError& error) { CHECK(std::string(error.what()).starts_with(data(name).string())); }
    }
}

// Assimp's memory limit depends on the size of its input: a glTF of 6 KB may name 335 MB.
TEST_CASE("import: the size of a glTF file is that of all that it names") {
    const size_t hole = size_t{3} << 30;  // a file with nothing in it takes no place on a disk
    const FileFolder folder;
    write_file(folder / "lightwalk named 1.bin", "");
    fs::resize_file(folder / "lightwalk named 1.bin", hole);
    const auto bytes = [&](const std::string& text) {
        write_file(folder / "names.gltf", text);
        return bytes_to_import(folder / "names.gltf") - text.size();
    };
    const std::string named = R"({"uri": "lightwalk%20named%201.bin"})";
    CHECK(bytes(R"({"buffers": [)" + named + "]}") == hole);
    CHECK(bytes(R"({"buffers": [)" + named + ", " + named + R"(], "images": [)" + named + "]}") == hole);
    CHECK(
        bytes(
            R"({"buffers": [{"uri": "data:application/octet-stream;base64,AAAA"}, {"uri": 7}, {"uri": "none.bin"}]})") ==
        0);
    CHECK(bytes(R"({"buffers": [{"uri": "."}, {"uri": "/dev/zero"}], "name": "lightwalk named 1.bin"})") == 0);
    CHECK(bytes(R"({"buffers": [)" + named + ", ") == 0);  // no JSON
    CHECK(bytes("") == 0);
    CHECK(bytes_to_import(data("nested.dae")) == fs::file_size(data("nested.dae")));
    CHECK_THROWS_AS(bytes_to_import(folder / "none.gltf"), InputError);
}

TEST_CASE("import: a buffer that is a pipe, a tree that is too deep, a position that is no number") {
    const FileFolder folder;
    const auto message = [&](const char* name, const std::string& text) {
        write_file(folder / name, text);
        return refusal_of([&] { import_model(folder / name); });
    };
    REQUIRE(mkfifo((folder / "pipe.bin").c_str(), 0600) == 0);
    CHECK(message("pipe.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "pipe.bin", "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}], "scene": 0})")
              .starts_with((folder / "pipe.gltf").string()));
    std::string deep = "<COLLADA version=\"1.4.1\"><asset/><library_visual_scenes><visual_scene id=\"s\">";
    for (int i = 0; i < 200000; ++i) deep += "<node>";
    CHECK(message("deep.dae", deep).starts_with((folder / "deep.dae").string()));
    const std::string ply = read_file(data("square.ply"));
    const size_t first = ply.find("end_header\n") + 11;
    CHECK(message("nan.ply", ply.substr(0, first) + "nan" + ply.substr(ply.find(' ', first))).find("nan.ply: ") !=
          std::string::npos);
}

// Two nodes a level, each with both of the next level as children: 2^30 paths in 4 KB.
TEST_CASE("import: nodes that form a lattice") {
    const FileFolder folder;
    const fs::path file = folder / "lattice.gltf";
    std::string nodes = R"({"children": [1, 2]})";
    for (int level = 0; level < 30; ++level)
        for (int twin = 0; twin < 2; ++twin)
            nodes += fmt::format(R"(, {{"children": [{}, {}]}})", 2 * level + 3, 2 * level + 4);
    write_file(file, R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36,
        "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "scenes": [{"nodes": [0]}], "scene": 0,
        "nodes": [)" + nodes +
                         R"(, {"mesh": 0}, {"mesh": 0}]})");
    CHECK(refusal_of([&] { import_model(file); }).starts_with(file.string() + ": node "));
}
