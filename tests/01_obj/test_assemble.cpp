// Assembly of a file that was read in one piece.
#include "01_obj/scan.h"
#include "catch.h"

using namespace lightwalk;

namespace {

struct Assembled {
    ObjData data;
    const void *positions, *normals, *corners;  // as they were read
};

Assembled assembled(std::string text) {
    const size_t bytes = text.size();
    text.append(64, '\0');
    Collected collected;
    const Piece piece = read_lines(std::string_view(text).substr(0, bytes), collected);
    Assembled result{{}, collected.positions.data(), collected.normals.data(), collected.corners.data()};
    bool absent = false;
    REQUIRE(assemble({&piece, 1}, 1, "test.obj", result.data, absent));
    CHECK_FALSE(absent);
    return result;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n";

}  // namespace

TEST_CASE("assemble: one piece's elements are the result's, and its corners where all are triangles",
          "[01.one_piece]") {
    const Assembled triangles = assembled(square + "f 1//1 2//1 3//1\nf -4//-1 3//1 4//1\n");
    CHECK(triangles.data.positions.data() == triangles.positions);
    CHECK(triangles.data.normals.data() == triangles.normals);
    CHECK(triangles.data.corners.data() == triangles.corners);
    const Assembled cut = assembled(square + "f 1//1 2//1 3//1 4//1\n");
    CHECK(cut.data.positions.data() == cut.positions);
    CHECK(cut.data.corners.data() != cut.corners);
    CHECK(cut.data.corners == triangles.data.corners);
}
