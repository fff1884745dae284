// The loaders' results, their agreement, and the inputs they refuse.
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <locale>

#include "01_obj/assemble.h"
#include "01_obj/load_bench.h"
#include "01_obj/mapped_file.h"
#include "01_obj/plain_parse.h"
#include "01_obj/truth.h"
#include "agreement.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

// Read by the textbook loader, after the others were found to agree.
ObjData read(std::string_view text) {
    CHECK(disagreement(text) == "");
    Outcome outcome = outcome_of(text, Loader::textbook);
    CHECK(outcome.error == "");
    return std::move(outcome.data);
}

void refuse(std::string_view text, size_t line) {
    CAPTURE(text);
    CHECK(disagreement(text) == "");
    for (const Loader loader : {Loader::textbook, Loader::scan, Loader::parallel}) {
        const Outcome outcome = outcome_of(text, loader);
        CHECK(outcome.place == "test.obj:" + std::to_string(line));
        CHECK(outcome.error.size() > outcome.place.size() + 10);  // there is a reason behind it
        CHECK(outcome.error.find('\n') == std::string::npos);
    }
}

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
    CHECK(positions_of(read(triangle + "f 1 2 3\n")) == Indices{0, 1, 2});
    const ObjData all =
        read(triangle + "vt 0 0\nvt 1 0.5\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 1//1 2//1 3//1\nf 1/2 2/1 3/2\n");
    REQUIRE(all.triangles() == 3);
    CHECK(all.corners[1] == Corner{1, 1, 0});
    CHECK(all.corners[3] == Corner{0, none, 0});
    CHECK(all.corners[6] == Corner{0, 1, none});
    CHECK(positions_of(read(triangle + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n")) == Indices{0, 1, 2, 3, 2, 1});
    CHECK(positions_of(read("f 1 2 3\n" + triangle)) == Indices{0, 1, 2});  // used before it is given
}

TEST_CASE("loaders: a corner ends with its line, whatever follows") {
    for (const std::string_view text : {"3/5", "3/4/5", "3//5"}) {
        std::string_view rest = text.substr(0, text.size() - 1);
        Corner corner;
        CHECK_FALSE(take_plain_corner(rest, corner));
        rest = text;
        CHECK(take_plain_corner(rest, corner));
    }
    std::string_view rest = std::string_view("3//").substr(0, 2);
    Corner corner;
    CHECK_FALSE(take_plain_corner(rest, corner));
}

TEST_CASE("loaders: what files in the wild look like") {
    CHECK(positions_of(read("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read(triangle + "f 1 2 3")) == Indices{0, 1, 2});
    CHECK(positions_of(read(triangle + "f 1 2 3\ng")) == Indices{0, 1, 2});
    CHECK(positions_of(read("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read(triangle + "f 1 \\\n2 \\\r\n 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read(triangle + "# C:\\models\\\nf 1 2 3\n")) == Indices{0, 1, 2});
    CHECK(positions_of(read("  v 0 0 0\n\tv\t1\t0\t0\t\nv  0  1  0 \n\n \nf  1\t2  3 # comment\n")) ==
          Indices{0, 1, 2});
    const ObjData colors = read("v 0 0 0 1 0 0\nv 1 0 0 1.0\nv 0 1 0 1 0.5 0.5 0.5\nvt 0.5\nvt 0.5 0.25 0\nf 1 2 3\n");
    CHECK(colors.positions.size() == 9);
    CHECK(colors.uvs.size() == 4);
    CHECK(colors.uvs[1] == 0.0f);
    const ObjData small = read("v 1e-400 -1e-400 1e-45\nv 1.00000000000000000000000001 .5 5.\nv +1 0 0\nf 1 2 3\n");
    CHECK(truth::ulps(small.positions[1], -0.0f) == 0);
    CHECK(read(triangle + "l 1 2\np 1\ns off\nvp 0.5\ncstype bezier\nf 1 2 3\n").triangles() == 1);
}

TEST_CASE("loaders: polygons lose nothing") {
    const std::string corners = "v 0 0 0\nv 2 -1 0\nv 0 2 0\nv -2 -1 0\nv 5 5 0\nv 5 6 0\n";
    CHECK(positions_of(read(corners + "f 1 2 3 4\n")) == Indices{0, 1, 2, 0, 2, 3});
    // The same arrow head from another corner: the cut from corner 0 to corner 2 lies outside.
    const Indices dent = positions_of(read(corners + "f 2 3 4 1\n"));
    REQUIRE(dent.size() == 6);
    for (size_t i = 0; i < 6; i += 3)
        CHECK(((dent[i] == 0) || (dent[i + 1] == 0) || (dent[i + 2] == 0)));  // both triangles meet the dent
    CHECK(read(corners + "f 1 2 3 4 5 6\nf 1 1 1 1 1\nf 1 1 1\n").triangles() == 4 + 3 + 1);
}

TEST_CASE("loaders: names make runs") {
    const ObjData data =
        read("mtllib a b.mtl\n" + triangle +
             "f 1 2 3\no my thing\ng left wheel\nusemtl old brass\nf 1 2 3\nf 3 2 1\nusemtl tin\nf 1 2 3\n"
             "usemtl tin\nf 1 2 3\nusemtl old brass\nf 1 2 3\no unused\n");
    CHECK(data.libraries == std::vector<std::string>{"a b.mtl"});
    CHECK(data.objects == std::vector<std::string>{"my thing", "unused"});
    CHECK(data.groups == std::vector<std::string>{"left wheel"});
    CHECK(data.materials == std::vector<std::string>{"old brass", "tin"});
    CHECK(data.runs == std::vector<Run>{{0, none, none, none}, {1, 0, 0, 0}, {3, 0, 0, 1}, {5, 0, 0, 0}});
}

TEST_CASE("loaders: malformed files are refused with their line") {
    refuse(triangle + "f 0 1 2\n", 4);
    refuse(triangle + "f 1 2 4\n", 4);
    refuse(triangle + "f 1 2 3\nf -4 1 2\nf 1 2\n", 5);
    refuse(triangle + "f 1 2 9\nv x\n", 4);  // the first error, not the first one noticed
    refuse(triangle + "v x\nf 1 2 9\n", 4);
    refuse(triangle + "f 1/-1 2/-1 3/-1\n", 4);
    refuse(triangle + "f 1/1073741824 2 3\n", 4);
    refuse("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", 1);  // as on a Mac before 2001
    refuse(triangle + "f 1 2 99999999999\n", 4);
    refuse(triangle + "f 1 2 -99999999999999999999999\n", 4);
    refuse(triangle + "f 1 2 1073741825\n", 4);
    refuse(triangle + "f 1 2\n", 4);
    refuse(triangle + "f\n", 4);
    refuse(triangle + "f 1/ 2/ 3/\n", 4);
    refuse(triangle + "f 1 2 3/\n", 4);
    refuse(triangle + "f 1 2 3/", 4);
    refuse(triangle + "f 1///1 2 3\n", 4);
    refuse(triangle + "f a b c\n", 4);
    refuse(triangle + "f 1,2,3\n", 4);
    refuse(triangle + "f 1.0 2 3\n", 4);
    refuse("v 0 0\n", 1);
    refuse("\n\n# c\nv 0 0 \\\n\nf 1 2 3", 4);  // a statement's first line is named
    refuse("v 0 0 nan\n", 1);
    refuse("v 0 0 inf\n", 1);
    refuse("v 0 0 1e39\n", 1);
    refuse("v 0 0 1,5\n", 1);
    refuse("v 0 0 0 0 0\n", 1);
    refuse("v 0 0 0 0 0 0 0 0\n", 1);
    refuse("vt\n", 1);
    refuse("vt 0 0 0 0\n", 1);
    refuse("vn 0 0\n", 1);
    refuse("vn 0 0 0 0\n", 1);
    refuse(triangle + "f 1 2 3\n1 2 3\n", 5);
    refuse(triangle + "f1 2 3\n", 4);
    refuse(triangle, 1);  // no face
    refuse("", 1);
    refuse(" \r\n\t", 1);
    refuse("hello world\n", 1);
    refuse(std::string("\x7f"
                       "ELF\0\0\0",
                       7),
           1);
    refuse(triangle + "f 1 2 3\n" + std::string(3000, 'x') + std::string(3, '\0') + "1\n", 1);
    refuse(triangle + "f 1 2 3\n\xEF\xBB\xBFv 1 2 3\n", 5);
}

TEST_CASE("loaders: a uv or a normal that is not there is left out, and the face stays") {
    const std::string some = triangle + "vt 0 0\nvn 0 0 1\n";
    const ObjData data = read(some + "f 1/1/1 2/2/1 3/1/9\nf 1/7 2/7 3/7\nf 1//2 2//1000000 3//1\n");
    REQUIRE(data.triangles() == 3);
    CHECK(data.corners[0] == Corner{0, 0, 0});
    CHECK(data.corners[1] == Corner{1, none, 0});
    CHECK(data.corners[2] == Corner{2, 0, none});
    for (size_t i = 3; i < 6; ++i) CHECK(data.corners[i].uv == none);
    CHECK(data.corners[8] == Corner{2, none, 0});
    CHECK(read(triangle + "f 1/1 2/1 3/1\nf 1//1 2//1 3//1\n").triangles() == 2);
    const Model model = weld(read(triangle + "f 1//1 2//1 3//1\n"), {}, "test");
    for (const Vertex& vertex : model.meshes.at(0).vertices) CHECK(vertex.normal == glm::vec3(0, 0, 1));
}

TEST_CASE("loaders: a file whose polygons take too long to cut is refused") {
    const std::string file = "test.obj";
    CuttingTime time(file, 0.02);
    const auto slow = [] {
        for (const std::clock_t start = std::clock(); std::clock() - start < CLOCKS_PER_SEC / 50;) {}
    };
    for (int i = 0; i < 3; ++i) time.count(5, slow);  // small polygons are not worth a look at the clock
    time.count(1000, [] {});
    CHECK_THROWS_AS((time.count(1000, slow), time.count(1000, slow)), InputError);
}

TEST_CASE("loaders: a file that becomes shorter while it is mapped is an error, not a signal") {
    const fs::path path = fs::temp_directory_path() / fmt::format("lightwalk_cut_{}.obj", getpid());
    std::string text = triangle;
    while (text.size() < 400000) text += "f 1 2 3\n";
    for (const size_t keep : {size_t{0}, size_t{5000}, size_t{200000}}) {
        write_file(path, text);
        const MappedFile file(path);
        size_t lines = static_cast<size_t>(std::count(file.text().begin(), file.text().begin() + 4096, '\n'));
        fs::resize_file(path, keep);
        lines += static_cast<size_t>(std::count(file.text().begin() + 4096, file.text().end(), '\n'));
        CHECK(lines < text.size() / 8);
        CHECK_THROWS_AS(file.check(), InputError);
    }
    write_file(path, text);
    const MappedFile whole(path);
    whole.check();
    fs::remove(path);
}

TEST_CASE("loaders: files that are none") {
    const fs::path folder = fs::temp_directory_path();
    const fs::path empty = folder / "lightwalk_empty.obj";
    write_file(empty, "");
    const fs::path pipe = folder / fmt::format("lightwalk_pipe_{}.obj", getpid());
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    for (const Loader loader :
         {Loader::textbook, Loader::tinyobjloader, Loader::assimp, Loader::scan, Loader::parallel}) {
        CHECK_THROWS_AS(parse_obj("/no/such/file.obj", loader), InputError);
        CHECK_THROWS_AS(parse_obj(folder, loader), InputError);
        for (const char* device : {"/dev/null", "/dev/zero", "/dev/full"})
            CHECK_THROWS_AS(parse_obj(device, loader), InputError);
        CHECK_THROWS_AS(parse_obj(pipe, loader), InputError);
        CHECK_THROWS_AS(parse_obj(empty, loader), InputError);
        CHECK_THROWS_AS(parse_obj(course_root() / "assets/models/smart_car_albedo.png", loader), InputError);
        CHECK_THROWS_AS(parse_obj_text(triangle, "test.obj", loader), InputError);
        CHECK_THROWS_AS(parse_obj_text(triangle + "f 1 2 99999999999\n", "test.obj", loader), InputError);
    }
    fs::remove(empty);
    fs::remove(pipe);
}

TEST_CASE("loaders: a comma in the locale changes nothing") {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const ObjData data = read("v 1.5 2.25 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::locale::global(before);
    CHECK(data.positions[0] == 1.5f);
    CHECK(data.positions[1] == 2.25f);
}

TEST_CASE("loaders: one long face") {
    std::string text, face = "f";
    for (int i = 0; i < 5000; ++i) {
        const double angle = 6.283185307179586 * i / 5000, radius = i % 2 ? 1.0 : 0.9;
        text +=
            "v " + std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    for (const Loader loader : {Loader::scan, Loader::parallel})
        CHECK(parse_obj_text(text + face + "\n", "test.obj", loader).triangles() == 4998);
    // A hundred thousand corners, crossing itself, and flat: an answer within seconds, and no triangle lost.
    std::string huge = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\nf";
    for (int i = 0; i < 100000; ++i) huge += i % 5 == 4 ? " 5" : " " + std::to_string(i % 5 + 1);
    CHECK(parse_obj_text(huge + "\n", "test.obj", Loader::parallel).triangles() == 99998);
    refuse(huge + " 1\n", 6);  // more than that are not cut
    std::string flat = "v 0 0 0\nv 1 0 0\nf";
    for (int i = 0; i < 50000; ++i) flat += " 1 2";
    CHECK(parse_obj_text(flat + "\n", "test.obj", Loader::parallel).triangles() == 99998);
    // Many names, in all loaders.
    std::string names = triangle;
    for (int i = 0; i < 20000; ++i) names += "g g" + std::to_string(i) + "\nf 1 2 3\n";
    CHECK(read(names).groups.size() == 20000);
    // Not so long a file that says it has many corners must not cost memory or time by that number.
    CHECK(outcome_of(triangle + "f 1000000000/1000000000/1000000000 1 2\n", Loader::parallel).place == "test.obj:4");
}

TEST_CASE("loaders: names of loaders") {
    for (const std::string_view name : loader_names()) CHECK(loader_name(loader_from_name(name)) == name);
    CHECK_THROWS_AS(loader_from_name("fastest"), InputError);
}

TEST_CASE("dump-mesh: the same positions, the same checksum") {
    const fs::path model = course_root() / "assets/models/smart_car.obj";
    const auto checksum = [&](Loader loader) {
        const std::string text = describe_mesh(model, loader);
        return text.substr(text.find("positions_fnv1a64"));
    };
    CHECK(checksum(Loader::textbook) == checksum(Loader::parallel));
    CHECK(checksum(Loader::scan) == checksum(Loader::parallel));
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
