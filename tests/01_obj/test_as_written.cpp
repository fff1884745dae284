// OBJ and MTL as other programs write them.
#include "01_obj/mtl.h"
#include "agreement.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/asset_path.h"
#include "tests/common/file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

const std::string written_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
// Two squares that meet in a right angle along the y axis.
const std::string corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\n";
const std::string squares = "f 1 2 3 4\nf 1 4 6 5\n";

ObjData read_as_written(const std::string& text) {
    CHECK(disagreement(text) == "");
    Outcome outcome = outcome_of(text, Loader::parallel);
    CHECK(outcome.error == "");
    return std::move(outcome.data);
}

Model model_of(const std::string& text) {
    const ObjData data = read_as_written(text);
    return weld(data, std::vector<Material>(data.materials.size()), "test");
}

Material material_of(const std::string& lines, Tr tr = Tr::safe) {
    return parse_mtl("newmtl m\n" + lines + "\n", "test.mtl", "folder", tr).at(0);
}

}  // namespace

TEST_CASE("obj as written: vertex colours are sRGB, of 1 or of 255; white where a position has none") {
    const std::string rest = "v 0 1 0\nf 1 2 3\n";
    const Model model = model_of("v 0 0 0 1 0.5 0\nv 1 0 0 1 0 0 0.5\n" + rest);
    const auto& colors = model.meshes[0].colors;
    REQUIRE(colors.size() == 3);
    CHECK(colors[0].r == 1);
    CHECK(std::abs(colors[0].g - 0.21404114f) < 1e-6f);                       // IEC 61966-2-1
    CHECK(glm::length(colors[1] - glm::vec4(0, 0, 0.21404114f, 1)) < 1e-6f);  // behind w
    CHECK(colors[2] == glm::vec4(1));
    CHECK(model_of("v 0 0 0 255 0 0\nv 1 0 0 0 0 255\n" + rest).meshes[0].colors[0] == glm::vec4(1, 0, 0, 1));
    CHECK(model_of(written_triangle + "f 1 2 3\n").meshes[0].colors.empty());
}

// As three.js and tinyobjloader take them: the colour behind x y z, and an opacity behind it. A w of polygons is 1.
TEST_CASE("obj as written: seven numbers are a colour with its opacity, unless the fourth ones can be w") {
    const auto color = [](const std::string& a, const std::string& b) {
        return model_of("v 0 0 0 " + a + "\nv 1 0 0 " + b + "\nv 0 1 0 1 1 1 1\nf 1 2 3\n").meshes[0].colors[0];
    };
    CHECK(color("1 0 0 1", "0 1 0 1") == glm::vec4(1, 0, 0, 1));
    CHECK(color("0 0 1 0.25", "0 1 0 1") == glm::vec4(0, 0, 1, 0.25f));
    CHECK(color("1 0 0 1", "1 1 0 1") == glm::vec4(1, 0, 0, 1));  // red or w: an opacity of 1 decides
    CHECK(color("1 0 0 1", "1 1 0 0") == glm::vec4(0, 0, 1, 1));  // w: blue is not always 1
    CHECK(color("255 0 0 255", "0 255 0 255") == glm::vec4(1, 0, 0, 1));
    CHECK(color("1 0 0 0", "0 1 0 0").a == 0);  // one has opacity, so that zeros are meant
}

// ZBrush's own comment: "4 hexadecimal values per vertex. The vertex color format is MMRRGGBB with up to 64 entries per
// MRGB line."
TEST_CASE("obj as written: colours that ZBrush writes as comments") {
    const std::string rest = "f 1 2 3\n";
    const Model model =
        model_of(written_triangle + "#MRGB ffff0000ff00ff00\n#MRGB 000000ff\n#End of MRGB block\n" + rest);
    const auto& colors = model.meshes[0].colors;
    REQUIRE(colors.size() == 3);
    CHECK((colors[0] == glm::vec4(1, 0, 0, 1) && colors[1] == glm::vec4(0, 1, 0, 1) &&
           colors[2] == glm::vec4(0, 0, 1, 1)));
    const ObjData quoted = read_as_written(written_triangle + "# as #MRGB ffff0000ff00ff00ff0000ff\n" + rest);
    CHECK((quoted.colors.empty() && quoted.left_out.empty()));
    const ObjData few = read_as_written(written_triangle + "#MRGB ffff0000\n" + rest);
    CHECK(few.colors.empty());
    CHECK(few.left_out == std::vector<std::string>{"#MRGB colours, which are not as many as the vertices"});
}

TEST_CASE("obj as written: smoothing groups") {
    const auto normals_at_origin = [](const std::string& text) {
        std::vector<glm::vec3> normals;
        const Model model = model_of(text);
        for (const Vertex& v : model.meshes[0].vertices)
            if (v.position == glm::vec3(0)) normals.push_back(v.normal);
        return normals;
    };
    const glm::vec3 x(1, 0, 0), z(0, 0, 1);
    CHECK(normals_at_origin(corner + squares).size() == 1);  // nothing said: smooth
    CHECK(normals_at_origin(corner + "s 1\n" + squares).size() == 1);
    CHECK(glm::length(normals_at_origin(corner + "s 1\n" + squares)[0] - glm::normalize(x + z)) < 1e-6f);
    for (const char* off : {"s off\n", "s 0\n"})
        for (const glm::vec3& n : normals_at_origin(corner + off + squares)) CHECK((n == x || n == z));
    const auto apart = normals_at_origin(corner + "s 1\nf 1 2 3 4\ns 2\nf 1 4 6 5\n");
    REQUIRE(apart.size() == 2);
    CHECK((apart[0] == z && apart[1] == x));
}

TEST_CASE("mtl as written: Tr, where it would make a material vanish") {
    CHECK(material_of("Tr 0.25").opacity == 0.75f);
    CHECK(material_of("Tr 1").opacity == 1);
    CHECK(material_of("Tr 1", Tr::transparency).opacity == 0);
    CHECK(material_of("Tr 0.25", Tr::opacity).opacity == 0.25f);
    CHECK(material_of("Tr 1\nd 0.5").opacity == 0.5f);
    CHECK(material_of("d 0").opacity == 0);
}

TEST_CASE("mtl as written: Tf filters what d lets through, by channel") {
    CHECK(material_of("d 0.25\nTf 0.5 1 0.125").transmission == glm::vec3(0.5f, 1, 0.125f));
    CHECK(material_of("Tf 0.5\nd 0.25").transmission == glm::vec3(0.5f));
    CHECK(material_of("d 0.25\nTf 0 51 255").transmission == glm::vec3(0, 0.2f, 1));  // some programs count to 255
    for (const char* nothing : {"d 0.25", "d 0.25\nTf 1 1 1", "d 0.25\nTf 0 0 0", "Tf 1 1 1", "Tf 0.5 1 1"}) {
        INFO(nothing);
        CHECK(material_of(nothing).transmission == Material().transmission);
    }
    using Names = std::vector<std::string>;
    CHECK(material_of("Tf 0.5 1 1").left_out == Names{"Tf of an opaque material"});
    CHECK(material_of("d 0.5\nTf spectral glass.rfl").left_out == Names{"Tf as a spectrum or XYZ"});
    CHECK(material_of("d 0.5\nTf 0.5 1 1").left_out.empty());
}

TEST_CASE("mtl as written: colours of 255, maps of roughness, where textures lie") {
    CHECK(material_of("Kd 255 51 0").diffuse == glm::vec3(1, 0.2f, 0));
    CHECK(material_of("Kd 1.5 0.5 0").diffuse == glm::vec3(1, 0.5f, 0));
    CHECK(material_of("Ke 17 12 4").emissive == glm::vec3(17, 12, 4));
    const Material rough = material_of("Ks 1 1 1\nNs 10\nmap_Pr r.png\nPm 0.5");
    CHECK((rough.metallic_roughness && rough.microfacets && rough.roughness == 1 && rough.metalness == 0.5f));
    CHECK(!rough.has_exponent);
    CHECK(material_of("Ks 1 1 1\nNs 10\nPr 0.5").has_exponent);
    const TextureMap map = material_of("map_Kd -s 2 4 1 -o 0.5 0.25 0 -clamp on a.png").diffuse_map;
    CHECK(map.place.turn * glm::vec2(1, 1) + map.place.offset == glm::vec2(2.5f, 4.25f));
    CHECK(map.sampler.wrap == Wrap::clamp);
    CHECK(material_of("illum 0").unlit);
    CHECK(material_of("map_Ke a.png").emissive == glm::vec3(1));
    CHECK(material_of("Ke 0 0 0\nmap_Ke a.png").emissive == glm::vec3(0));
    CHECK(material_of("Kd 0 0 0\nmap_Kd a.png").diffuse == glm::vec3(1));
    CHECK(material_of("Kd 0 0 0").diffuse == glm::vec3(0));
    CHECK(material_of("map_Normal a.png").normal_map);
    CHECK(material_of("map_d a.png").opacity_map.channel == alpha_if_any);
    CHECK(material_of("map_d -imfchan g a.png").opacity_map.channel == 'g');
    using Names = std::vector<std::string>;
    CHECK(material_of("refl -type sphere a.png\nTf 1 1 1\nPc 0.5\naniso 0").left_out == Names{"refl", "Pc"});
    CHECK(material_of("map_ORM a.png").left_out == Names{"map_ORM"});
}

TEST_CASE("mtl as written: file names in other capitals, or of a folder that is gone") {
    const FileFolder folder;
    write_file(folder / "Wood.PNG", "");
    for (const char* written : {"wood.png", "Wood.PNG", "textures/wood.png", "C:\\maps\\WOOD.png"})
        CHECK(resolve_file(written, folder.path) == folder / "Wood.PNG");
    CHECK(resolve_file("stone.png", folder.path) == folder / "stone.png");
}
