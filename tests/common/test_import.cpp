// Other formats: transforms in the right order, units, axes and materials, bad files refused. FBX and 3MF are in
// assets/conformance.
#include <sys/stat.h>

#include "common/base/files.h"
#include "common/scene/asset_path.h"
#include "common/scene/import.h"
#include "file_fixture.h"
#include "import_fixture.h"

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

namespace {

// One triangle; a unit is half a metre, and z is up.
std::string collada(const std::string& technique) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.5"/><up_axis>Z_UP</up_axis></asset><library_effects><effect id="e"><profile_COMMON><technique sid="t">)" +
           technique + R"(</technique></profile_COMMON></effect></library_effects><library_materials><material id="m">
<instance_effect url="#e"/></material></library_materials><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 0 2</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<lines count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1</p></lines>
<triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

Material material_of_collada(const std::string& technique) {
    const Model model = model_of("one.dae", collada(technique));
    return model.materials.at(model.meshes.at(0).parts.at(0).material);
}

}  // namespace

// COLLADA 1.4.1, "lambert", "phong", "transparent": opacity is alpha times transparency for A_ONE. SketchUp 6 wrote 0 there.
TEST_CASE("COLLADA: reflection, and transparency that would make a material vanish") {
    const std::string red = "<diffuse><color>1 0 0 1</color></diffuse>",
                      one = "<transparent opaque=\"A_ONE\"><color>1 1 1 1</color></transparent>";
    CHECK(material_of_collada("<lambert>" + red + "</lambert>").specular == glm::vec3(0));
    CHECK(material_of_collada("<phong>" + red + "<specular><color>0 1 0 1</color></specular></phong>").specular ==
          glm::vec3(0, 1, 0));
    const auto opacity = [&](const char* number) {
        return material_of_collada("<lambert>" + red + one + "<transparency><float>" + number +
                                   "</float></transparency></lambert>")
            .opacity;
    };
    CHECK(std::abs(opacity("0.25") - 0.25f) < 1e-6f);
    CHECK(opacity("0") == 1);
}

// Lines and points of COLLADA stand beside its triangles.
TEST_CASE("COLLADA: lines are named, and the triangles are drawn") {
    const Model model = model_of("lines.dae", collada("<lambert/>"));
    CHECK(left_out_text(model) == "lines (1 mesh)");
    REQUIRE(model.meshes.size() == 1);
    const Bounds box = model_bounds(model);
    CHECK(glm::length(box.upper - glm::vec3(0.5f, 1, 0)) < 1e-6f);  // z is up, a unit is 0.5 m
}

TEST_CASE("OFF: what is malformed is refused in one line") {
    const auto said = [](const std::string& text, const char* why) {
        const std::string error = error_of_model("bad.off", text);
        CAPTURE(text, error);
        CHECK(error.find(why) != std::string::npos);
    };
    said("OFF BINARY\n\1\2\3", "binary OFF");
    said("nOFF\n4\n", "expected OFF with any of");
    said("OFF\n4 1 0\n0 0 0\n", "the file ends after 1 of 4 vertices");
    said("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "bad.off:6: vertex 3 of 3");
    said("OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n", "bad.off:4: 'x' is not a number");
    said("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", "bad.off:6: '1.5' is not an integer from 0");
    said("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "bad.off:6: '-1' is not an integer from 0");
    said("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", "bad.off:6: 3 corners of a face, expected 4");
    said("OFF\n99999999 1 0\n0 0 0\n", "bad.off:2: the header announces more");
    said("OFF\n2 0 0\n0 0 0\n1 0 0\n", "a point cloud");
}

TEST_CASE("height maps are no models, and are sent to chapter 15") {
    for (const char* name : {"N46E007.hgt", "dem.tif", "dem.TIFF"}) {
        const std::string error = error_of_model(name, std::string(64, '\1'));
        CAPTURE(error);
        CHECK(error.find("a height map or an image, expected a model; chapter 15 reads heights of .hgt") !=
              std::string::npos);
    }
}
