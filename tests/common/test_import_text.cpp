// Malformed files of formats without materials. What they hold otherwise is in assets/conformance.
#include "import_fixture.h"

using namespace lightwalk;

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
