// Colours of formats without materials: as their specifications and three programs write them.
#include <cstring>

#include "import_fixture.h"

using namespace lightwalk;

namespace {

const std::string corners[] = {"-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"};
const glm::vec4 red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1), white(1);

// The colours at a position, of each of its vertices.
std::vector<glm::vec4> colors_at(const Model& model, glm::vec3 position) {
    std::vector<glm::vec4> colors;
    for (const Mesh& mesh : model.meshes)
        for (size_t i = 0; i < mesh.vertices.size(); ++i)
            if (mesh.vertices[i].position == position) colors.push_back(mesh.colors.empty() ? white : mesh.colors[i]);
    return colors;
}

bool are(const std::vector<glm::vec4>& colors, std::vector<glm::vec4> expected) {
    const auto near = [](glm::vec4 a, glm::vec4 b) { return glm::length(a - b) < 1e-3f; };
    if (colors.size() != expected.size()) return false;
    for (const glm::vec4& color : colors) {
        const auto found = std::find_if(expected.begin(), expected.end(), [&](glm::vec4 e) { return near(color, e); });
        if (found == expected.end()) return false;
        expected.erase(found);
    }
    return true;
}

// Lines of vertices with a text behind each, and the faces.
std::string rows(const char* const (&behind)[4], const std::string& faces) {
    std::string text;
    for (size_t i = 0; i < 4; ++i) text += corners[i] + behind[i] + "\n";
    return text + faces;
}

constexpr const char* plain[4] = {"", "", "", ""};
const std::string square = "4 0 1 2 3\n", halves = "3 0 1 2 {}\n3 0 2 3 {}\n";

}  // namespace

// Geomview's manual, "OFF": a face's colour is 3 or 4 integers of 255 or floats of 1 behind its corners; 0.735 in sRGB is
// 0.5 in linear light.
TEST_CASE("OFF: colours of faces, of vertices, and the header's letters") {
    for (const auto& [one, other] :
         {std::pair("255 0 0", "0 255 0"), {"1.0 0 0", "0 1.0 0"}, {"255 0 0 255", "0 255 0 255"}}) {
        CAPTURE(one);
        const Model model =
            model_of("faces.off", "OFF\n4 2 5\n" + rows(plain, fmt::format(fmt::runtime(halves), one, other)));
        CHECK(are(colors_at(model, {1, -1, 0}), {red}));
        CHECK(are(colors_at(model, {1, 1, 0}), {red, green}));
        CHECK(are(colors_at(model, {-1, 1, 0}), {green}));
        CHECK(model.left_out.empty());
    }
    const std::string rest = rows({" 255 0 0 255", " 0 255 0 255", " 0 188 0 255", " 255 0 0 255"}, square);
    for (const char* head : {"COFF\n4 1 0\n", "COFF 4 1 0\n", "OFF # of a scanner\n# another\n\n4 1 0\n", "4 1 0\n"}) {
        CAPTURE(head);
        const Model model = model_of("vertices.off", head + rest);
        CHECK(are(colors_at(model, {-1, -1, 0}), {red}));
        CHECK(are(colors_at(model, {1, -1, 0}), {green}));
        CHECK(std::abs(colors_at(model, {1, 1, 0}).at(0).g - 0.5029f) < 1e-3f);  // IEC 61966-2-1 of 188/255
    }
    const Model all =
        model_of("all.off", "STCNOFF\n4 1 0\n" + rows({" 0 1 0 255 0 0 1 0 0.25", " 0 1 0 0 255 0 1 1 0.25",
                                                       " 0 1 0 0 255 0 1 1 1", " 0 1 0 255 0 0 1 0 1"},
                                                      square));
    CHECK(are(colors_at(all, {-1, 1, 0}), {{1, 0, 0, 1 / 255.0f}}));
    for (const Vertex& v : all.meshes.at(0).vertices) {
        CHECK(v.normal == glm::vec3(0, 1, 0));
        CHECK(v.uv == glm::vec2(v.position.x > 0, v.position.y > 0 ? 1 : 0.25f));
    }
    CHECK(left_out_text(model_of("index.off", "OFF\n4 1 0\n" + rows(plain, "4 0 1 2 3 7\n"))) == "colours by index");
    const Model four = model_of("four.off", "4OFF\n3 1 0\n2 0 0 2\n0 2 0 1\n0 0 3 1\n3 0 1 2\n");
    CHECK(four.meshes.at(0).vertices.at(0).position == glm::vec3(1, 0, 0));
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

namespace {

// Properties of vertices beside x, y and z, and of faces, each with its type.
std::string ply(const std::string& of_vertices, const std::string& of_faces, const std::string& data,
                const std::string& counts = "4 1") {
    const auto declared = [](const std::string& list) {
        std::string text;
        std::istringstream words(list);
        for (std::string type, name; words >> type >> name;) text += "property " + type + " " + name + "\n";
        return text;
    };
    return "ply\nformat ascii 1.0\nelement vertex " + counts.substr(0, 1) + "\n" +
           declared("float x float y float z " + of_vertices) + "element face " + counts.substr(2) +
           "\nproperty list uchar int vertex_indices\n" + declared(of_faces) + "end_header\n" + data;
}

}  // namespace

TEST_CASE("PLY: colours of vertices by all their names and types; others are named") {
    const std::string by_255 = rows({" 255 0 0", " 0 255 0", " 0 255 0", " 255 0 0"}, square);
    for (const char* names :
         {"uchar red uchar green uchar blue", "uchar diffuse_red uchar diffuse_green uchar diffuse_blue",
          "uchar r uchar g uchar b", "float red float green float blue"}) {
        CAPTURE(names);
        const Model model = model_of("colors.ply", ply(names, "", by_255));
        CHECK(are(colors_at(model, {-1, -1, 0}), {red}));
        CHECK(are(colors_at(model, {1, -1, 0}), {green}));
        CHECK(model.left_out.empty());
    }
    const std::string halved = rows({" 1 0 0", " 0 1 0", " 0 .735357 0", " 1 0 0"}, square);
    const Model floats = model_of("floats.ply", ply("float red float green float blue", "", halved));
    CHECK(are(colors_at(floats, {1, 1, 0}), {{0, 0.5f, 0, 1}}));  // IEC 61966-2-1
    const Model faces =
        model_of("faces.ply", ply("", "uchar red uchar green uchar blue", rows(plain, "4 0 1 2 3 255 0 0\n")));
    CHECK(left_out_text(faces) == "colours of faces");
    const Model scan = model_of("scan.ply", ply("float quality float f_rest_0 float f_rest_1", "",
                                                rows({" 1 2 3", " 1 2 3", " 1 2 3", " 1 2 3"}, square)));
    CHECK(left_out_text(scan) == "quality (1 vertex number), f_rest (2 vertex numbers)");
    std::string edges = ply("", "", rows(plain, square + "0 1\n"));
    edges.insert(edges.find("end_header"), "element edge 1\nproperty int vertex1\nproperty int vertex2\n");
    CHECK(left_out_text(model_of("edges.ply", edges)) == "element edge");
    CHECK(error_of_model("cut.ply", edges.substr(0, 60)).find("no end_header") != std::string::npos);
    std::string strips = ply("", "", rows(plain, "4 0 1 3 2\n"));
    strips.replace(strips.find("element face"), 12, "element tristrips");
    CHECK(error_of_model("strips.ply", strips).find("triangles are strips") != std::string::npos);
}

// Two triangles of two colours meet at an edge: four of its six corners are at two positions.
TEST_CASE("vertices that differ in their colours alone stay apart") {
    const std::string text =
        ply("uchar red uchar green uchar blue", "",
            "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n0 0 0 0 255 0\n0 1 0 0 255 0\n-1 0 0 0 255 0\n"
            "3 0 1 2\n3 3 4 5\n",
            "6 2");
    const Model model = model_of("two.ply", text);
    CHECK(are(colors_at(model, {0, 0, 0}), {red, green}));
    CHECK(are(colors_at(model, {0, 1, 0}), {red, green}));
}

namespace {

// Two triangles of a square with attribute words.
std::string binary_stl(std::string header, std::array<uint16_t, 2> words) {
    header.resize(80, ' ');
    const float triangles[2][12] = {{0, 0, 1, -1, -1, 0, 1, -1, 0, 1, 1, 0}, {0, 0, 1, -1, -1, 0, 1, 1, 0, -1, 1, 0}};
    std::string bytes = header + std::string("\2\0\0\0", 4);
    for (int i = 0; i < 2; ++i) {
        bytes.append(reinterpret_cast<const char*>(triangles[i]), 48);
        bytes.append(reinterpret_cast<const char*>(&words[i]), 2);
    }
    return bytes;
}

}  // namespace

// VisCAM: bit 15 says that the colour counts, blue in the lowest five bits. Materialise Magics: "COLOR=" and RGBA in the
// header; bit 15 says that this colour counts, red in the lowest five bits.
TEST_CASE("STL: colours of triangles, in two programs' ways") {
    const uint16_t low = 31, high = 31 << 10, bit = 1 << 15;
    const Model viscam = model_of("viscam.stl", binary_stl("part", {uint16_t(bit | low), uint16_t(bit | high)}));
    CHECK(are(colors_at(viscam, {1, -1, 0}), {blue}));
    CHECK(are(colors_at(viscam, {-1, 1, 0}), {red}));
    CHECK(are(colors_at(viscam, {1, 1, 0}), {blue, red}));
    const Model magics = model_of("magics.stl", binary_stl(std::string("COLOR=\0\377\0\377", 10), {low, bit}));
    CHECK(are(colors_at(magics, {1, -1, 0}), {red}));
    CHECK(are(colors_at(magics, {-1, 1, 0}), {green}));
    const Model own = model_of("own.stl", binary_stl(std::string("COLOR=\0\377\0\377", 10), {low, high}));
    CHECK(are(colors_at(own, {1, 1, 0}), {red, blue}));
    const Model header = model_of("header.stl", binary_stl(std::string("COLOR=\0\377\0\377,MATERIAL=", 20), {0, 0}));
    CHECK(are(colors_at(header, {1, 1, 0}), {green, green}));
    CHECK(left_out_text(header) == "MATERIAL of its header");
    CHECK(model_of("plain.stl", binary_stl("part", {0, 0})).meshes.at(0).colors.empty());
    for (const Model* model : {&viscam, &magics, &header}) CHECK(model->materials.at(0).diffuse == glm::vec3(1));
}

TEST_CASE("height maps are no models, and are sent to chapter 15") {
    for (const char* name : {"N46E007.hgt", "dem.tif", "dem.TIFF"}) {
        const std::string error = error_of_model(name, std::string(64, '\1'));
        CAPTURE(error);
        CHECK(error.find("a height map or an image, expected a model; chapter 15 reads heights of .hgt") !=
              std::string::npos);
    }
}
