#include <ctime>

#include "01_obj/obj.h"
#include "catch.h"

using namespace lightwalk;

namespace {

Model welded(const std::string& text) { return weld(parse_obj_text(text, "test.obj", Loader::parallel), {}, "test"); }

}  // namespace

TEST_CASE("weld: equal triples become one vertex, different ones do not") {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 2\nvn 0 1 0\n";
    const Model shared = welded(square + "f 1/1/1 2/1/1 3/1/1 4/1/1\n");
    CHECK(shared.meshes[0].vertices.size() == 4);
    CHECK(shared.meshes[0].indices == std::vector<uint32_t>{0, 1, 2, 0, 2, 3});
    CHECK(shared.meshes[0].vertices[0].normal == glm::vec3(0, 0, 1));  // unit length
    CHECK(shared.meshes[0].bounds.upper == glm::vec3(1, 1, 0));
    CHECK(welded(square + "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n").meshes[0].vertices.size() == 5);
    CHECK(welded(square + "f 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/1 4/1/1\n").meshes[0].vertices.size() == 5);
}

TEST_CASE("weld: missing normals are smooth, by area, also across a seam of uvs") {
    // Two faces at a right angle; the upright one has twice the area.
    const Model model = welded("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n");
    const Mesh& mesh = model.meshes[0];
    CHECK(mesh.vertices.size() == 6);
    const glm::vec3 both = glm::normalize(glm::vec3(2, 0, 1));
    CHECK(glm::length(mesh.vertices[0].normal - both) < 1e-6f);
    CHECK(mesh.vertices[0].normal == mesh.vertices[3].normal);
    CHECK(mesh.vertices[1].normal == glm::vec3(0, 0, 1));
    // A face without area has no normal to give.
    CHECK(welded("v 1 1 1\nf 1 1 1\n").meshes[0].vertices[0].normal == glm::vec3(0, 1, 0));
    // A normal of length 0 counts as missing.
    CHECK(welded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3\n").meshes[0].vertices[0].normal ==
          glm::vec3(0, 0, 1));
    for (const std::string smooth : {"", "s 1\n", "s off\n"}) {
        const Model none_given =
            welded("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 0\n" + smooth + "f 1//1 2//1 3//1 4//1\n");
        for (const Vertex& v : none_given.meshes[0].vertices) CHECK(v.normal == glm::vec3(0, 0, 1));
    }
    // Given and missing ones in a file.
    const Model mixed = welded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 2 3\n");
    CHECK(mixed.meshes[0].vertices[0].normal == glm::vec3(1, 0, 0));
    CHECK(mixed.meshes[0].vertices[3].normal == glm::vec3(0, 0, 1));
    // Areas of 1e77 and of 1e-80.
    for (const std::string far : {"3e38", "1e-40"}) {
        const Model model_far = welded("v 0 0 0\nv " + far + " 0 0\nv 0 " + far + " 0\nf 1 2 3\n");
        for (const Vertex& v : model_far.meshes[0].vertices) CHECK(v.normal == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("weld: a mesh and a node for each object, a part for each material") {
    const Model model = welded(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no a\nusemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl x\nf 3 2 1\n"
        "o b\nf 1 2 3\no a\nf 1 2 3\no none\n");
    REQUIRE(model.meshes.size() == 3);
    REQUIRE(model.nodes.size() == 3);
    CHECK(model.meshes[0].name == "test");
    CHECK(model.meshes[1].name == "a");
    CHECK(model.nodes[2].name == "b");
    CHECK(model.nodes[2].meshes == std::vector<uint32_t>{2});
    REQUIRE(model.meshes[1].parts.size() == 2);
    CHECK(model.meshes[1].parts[0].index_count == 9);
    CHECK(model.meshes[1].parts[1].first_index == 9);
    CHECK(model.meshes[1].vertices.size() == 3);
    CHECK(model.meshes[2].vertices.size() == 3);
    for (const Mesh& mesh : model.meshes)
        for (const uint32_t index : mesh.indices) CHECK(index < mesh.vertices.size());
    CHECK(model.materials.size() == 3);  // x, y, and one for faces without
}

TEST_CASE("weld: one position with very many uvs takes no longer than as many positions") {
    constexpr uint32_t count = 200000;
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (uint32_t i = 0; i < count; ++i) text += fmt::format("vt {} 0\n", i);
    for (uint32_t twice = 0; twice < 2; ++twice)
        for (uint32_t i = 1; i <= count; ++i) text += fmt::format("f 1/{} 2/1 3/1\n", i);
    const ObjData data = parse_obj_text(text, "test.obj", Loader::parallel);
    const std::clock_t start = std::clock();
    const Model model = weld(data, {}, "test");
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 5);  // 0.1 s; without the hash map a minute
    REQUIRE(model.meshes.size() == 1);
    const Mesh& mesh = model.meshes[0];
    CHECK(mesh.vertices.size() == count + 2);
    for (uint32_t i = 0; i < count; ++i) {  // the second run finds the first one's file
        if (mesh.indices[3 * i] == mesh.indices[3 * (count + i)] && mesh.vertices[mesh.indices[3 * i]].uv.x == float(i))
            continue;
        FAIL("uv " << i);
    }
}
