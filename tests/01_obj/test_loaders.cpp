// The loaders' results and their agreement.
#include <filesystem>

#include "01_obj/scan.h"
#include "01_obj/truth.h"
#include "common/base/files.h"
#include "common/check/comma_locale.h"
#include "loader_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

std::vector<uint32_t> positions_of(const ObjData& data) {
    std::vector<uint32_t> indices;
    for (const Corner& c : data.corners) indices.push_back(c.position);
    return indices;
}

using Indices = std::vector<uint32_t>;

}  // namespace

TEST_CASE("loaders: all agree with each other and the truth on every model of the course") {
    size_t models = 0;
    for (const auto& entry : fs::directory_iterator(course_root() / "assets" / "models")) {
        if (entry.path().extension() != ".obj") continue;
        CAPTURE(entry.path());
        const std::string text = read_file(entry.path());
        const ObjData expected = truth::parse(text);
        for (const Loader loader : {Loader::textbook, Loader::scan, Loader::parallel}) {
            const ObjData data = parse_obj(entry.path(), loader);
            CHECK(data.positions == expected.positions);
            CHECK(data.uvs == expected.uvs);
            CHECK(data.normals == expected.normals);
            CHECK(data.corners == expected.corners);
        }
        for (const size_t chunk : {1000u, 4099u, 65536u}) {
            const ObjData data = parse_obj_text(text, "test.obj", Loader::parallel, {chunk, 3});
            CHECK(data.corners == expected.corners);
            CHECK(data.positions == expected.positions);
        }
        CHECK(parse_obj(entry.path(), Loader::tinyobjloader).positions.size() == expected.positions.size());
        CHECK(parse_obj(entry.path(), Loader::assimp).triangles() >= expected.triangles() / 2);
        ++models;
    }
    CHECK(models >= 10);
}

TEST_CASE("loaders: every form of a corner") {
    CHECK(positions_of(read_text(triangle + "f 1 2 3\n")) == Indices{0, 1, 2});
    const ObjData all =
        read_text(triangle + "vt 0 0\nvt 1 0.5\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 1//1 2//1 3//1\nf 1/2 2/1 3/2\n");
    REQUIRE(all.triangles() == 3);
    CHECK(all.corners[1] == Corner{1, 1, 0});
    CHECK(all.corners[3] == Corner{0, none, 0});
    CHECK(all.corners[6] == Corner{0, 1, none});
    CHECK(positions_of(read_text(triangle + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n")) == Indices{0, 1, 2, 3, 2, 1});
    CHECK(positions_of(read_text("f 1 2 3\n" + triangle)) == Indices{0, 1, 2});  // used before it is given
}

TEST_CASE("loaders: what files in the wild look like") {
    CHECK(positions_of(read_text("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text(triangle + "f 1 2 3")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text(triangle + "f 1 2 3\ng")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text(triangle + "f 1 \\\n2 \\\r\n 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text(triangle + "# C:\\models\\\nf 1 2 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read_text("  v 0 0 0\n\tv\t1\t0\t0\t\nv  0  1  0 \n\n \nf  1\t2  3 # comment\n")) ==
          Indices{0, 1, 2});
    const ObjData colors =
        read_text("v 0 0 0 1 0 0\nv 1 0 0 1.0\nv 0 1 0 1 0.5 0.5 0.5\nvt 0.5\nvt 0.5 0.25 0\nf 1 2 3\n");
    CHECK(colors.positions.size() == 9);
    CHECK(colors.uvs.size() == 4);
    CHECK(colors.uvs[1] == 0.0f);
    const ObjData small =
        read_text("v 1e-400 -1e-400 1e-45\nv 1.00000000000000000000000001 .5 5.\nv +1 0 0\nf 1 2 3\n");
    CHECK(truth::ulps(small.positions[1], -0.0f) == 0);
    CHECK(read_text(triangle + "l 1 2\np 1\ns off\nvp 0.5\ncstype bezier\nf 1 2 3\n").triangles() == 1);
}

TEST_CASE("loaders: polygons lose nothing") {
    const std::string corners = "v 0 0 0\nv 2 -1 0\nv 0 2 0\nv -2 -1 0\nv 5 5 0\nv 5 6 0\n";
    CHECK(positions_of(read_text(corners + "f 1 2 3 4\n")) == Indices{0, 1, 2, 0, 2, 3});
    // The same arrow head from another corner: the cut from corner 0 to corner 2 lies outside.
    const Indices dent = positions_of(read_text(corners + "f 2 3 4 1\n"));
    REQUIRE(dent.size() == 6);
    for (size_t i = 0; i < 6; i += 3)
        CHECK(((dent[i] == 0) || (dent[i + 1] == 0) || (dent[i + 2] == 0)));  // both triangles meet the dent
    CHECK(read_text(corners + "f 1 2 3 4 5 6\nf 1 1 1 1 1\nf 1 1 1\n").triangles() == 4 + 3 + 1);
}

TEST_CASE("loaders: names make runs") {
    const ObjData data =
        read_text("mtllib a b.mtl\n" + triangle +
                  "f 1 2 3\no my thing\ng left wheel\nusemtl old brass\nf 1 2 3\nf 3 2 1\nusemtl tin\nf 1 2 3\n"
                  "usemtl tin\nf 1 2 3\nusemtl old brass\nf 1 2 3\no unused\n");
    CHECK(data.libraries == std::vector<std::string>{"a b.mtl"});
    CHECK(data.objects == std::vector<std::string>{"my thing", "unused"});
    CHECK(data.groups == std::vector<std::string>{"left wheel"});
    CHECK(data.materials == std::vector<std::string>{"old brass", "tin"});
    CHECK(data.runs == std::vector<Run>{{0, none, none, none}, {1, 0, 0, 0}, {3, 0, 0, 1}, {5, 0, 0, 0}});
}

TEST_CASE("loaders: a uv or a normal that is not there is left out, and the face stays") {
    const std::string some = triangle + "vt 0 0\nvn 0 0 1\n";
    const ObjData data = read_text(some + "f 1/1/1 2/2/1 3/1/9\nf 1/7 2/7 3/7\nf 1//2 2//1000000 3//1\n");
    REQUIRE(data.triangles() == 3);
    CHECK(data.corners[0] == Corner{0, 0, 0});
    CHECK(data.corners[1] == Corner{1, none, 0});
    CHECK(data.corners[2] == Corner{2, 0, none});
    for (size_t i = 3; i < 6; ++i) CHECK(data.corners[i].uv == none);
    CHECK(data.corners[8] == Corner{2, none, 0});
    CHECK(read_text(triangle + "f 1/1 2/1 3/1\nf 1//1 2//1 3//1\n").triangles() == 2);
    const Model model = weld(read_text(triangle + "f 1//1 2//1 3//1\n"), {}, "test");
    for (const Vertex& vertex : model.meshes.at(0).vertices) CHECK(vertex.normal == glm::vec3(0, 0, 1));
}

TEST_CASE("loaders: a comma in the locale changes nothing") {
    const CommaLocale comma;
    CHECK(std::strtof("1,5", nullptr) == 1.5f);
    const ObjData data = read_text("v 1.5 2.25 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(data.positions[0] == 1.5f);
    CHECK(data.positions[1] == 2.25f);
}

// On two cores 5 MB take one thread 4.3 ms and two 4.4 to 7.2, 16 MB take 25.9 and 15.2; sixteen cores read 5 MB in a
// third of one core's time.
TEST_CASE("loaders: a text is cut for threads from the size on at which they win", "[01.chunks]") {
    constexpr size_t mebi = size_t{1} << 20;
    for (const size_t bytes : {size_t{1}, mebi, 5 * mebi})
        for (const unsigned threads : {1u, 2u}) CHECK(chunk_bytes_for(bytes, threads) >= bytes);
    for (const unsigned threads : {2u, 4u, 16u}) CHECK(chunk_bytes_for(100 * mebi, threads) == mebi);
    CHECK(chunk_bytes_for(16 * mebi, 2) <= 8 * mebi);
    CHECK(chunk_bytes_for(5 * mebi, 16) <= 5 * mebi / 16);
    CHECK(chunk_bytes_for(mebi / 4, 16) >= mebi / 4);
}

TEST_CASE("corpus: every file through every loader of ours") {
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(course_root() / "tests/01_obj/corpus/obj")) {
        CAPTURE(entry.path());
        CHECK(disagreement(read_file(entry.path())) == "");
        ++files;
    }
    CHECK(files >= 20);
}
