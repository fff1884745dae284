// Inputs that the loaders refuse, and those that would take long.
#include <cmath>
#include <ctime>

#include "01_obj/scan.h"
#include "common/base/error.h"
#include "loader_fixture.h"

using namespace lightwalk;

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
    refuse(triangle + "f 1 2\n", 4);
    refuse(triangle + "f\n", 4);
    refuse(triangle + "f 1/ 2/ 3/\n", 4);
    refuse(triangle + "f 1 2 3/", 4);
    refuse(triangle + "f 1///1 2 3\n", 4);
    refuse(triangle + "f a b c\n", 4);
    refuse(triangle + "f 1.0 2 3\n", 4);
    refuse("v 0 0\n", 1);
    refuse("\n\n# c\nv 0 0 \\\n\nf 1 2 3", 4);  // a statement's first line is named
    refuse("v 0 0 nan\n", 1);
    refuse("v 0 0 inf\n", 1);
    refuse("v 0 0 1e39\n", 1);
    refuse("v 0 0 1,5\n", 1);
    refuse("v 0 0 0 0 0 0 0 0\n", 1);
    refuse("vt\n", 1);
    refuse("vn 0 0\n", 1);
    refuse(triangle + "f 1 2 3\n1 2 3\n", 5);
    refuse(triangle, 1);  // no face
    refuse(" \r\n\t", 1);
    refuse(std::string("\x7f"
                       "ELF\0\0\0",
                       7),
           1);
    refuse(triangle + "f 1 2 3\n" + std::string(3000, 'x') + std::string(3, '\0') + "1\n", 1);
    refuse(triangle + "f 1 2 3\n\xEF\xBB\xBFv 1 2 3\n", 5);
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
    CHECK(read_text(names).groups.size() == 20000);
    // Not so long a file that says it has many corners must not cost memory or time by that number.
    CHECK(outcome_of(triangle + "f 1000000000/1000000000/1000000000 1 2\n", Loader::parallel).place == "test.obj:4");
}
