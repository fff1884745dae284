#include "01_obj/mtl.h"
#include "01_obj/obj.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "tests/common/file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

Material one(const std::string& lines) {
    const auto materials = parse_mtl("newmtl m\n" + lines + "\n", "test.mtl", "folder");
    REQUIRE(materials.size() == 1);
    return materials[0];
}

void refuse(const std::string& text, int line) {
    CAPTURE(text);
    try {
        parse_mtl(text, "test.mtl", "");
        FAIL_CHECK("it found nothing wrong");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).starts_with("test.mtl:" + std::to_string(line) + ": "));
    }
}

}  // namespace

TEST_CASE("mtl: colours and numbers") {
    const Material m =
        one("Ka 0.1 0.2 0.3\r\nKd 0.5\nKs 1 0 1 # pink\nKe 17 12 4\n Ns 600\nNi 1.376\nd 0.25\nillum 4\nPr 0.3\nPm 1");
    CHECK(m.name == "m");
    CHECK(m.ambient == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(m.diffuse == glm::vec3(0.5f));
    CHECK(m.specular == glm::vec3(1, 0, 1));
    CHECK(m.emissive == glm::vec3(17, 12, 4));
    CHECK(m.shininess == 600.0f);
    CHECK(m.refraction == 1.376f);
    CHECK(m.opacity == 0.25f);
    CHECK(m.illumination == 4);
    CHECK(m.roughness == 0.3f);
    CHECK(m.metalness == 1.0f);
    CHECK(one("Tr 0.25").opacity == 0.75f);
    CHECK(one("d 0.5\nTr 0.9").opacity == 0.5f);
    CHECK(one("d -halo 0.5").opacity == 0.5f);
    CHECK(one("Kd spectral file.rfl 1\nKs xyz 1 1 1\nTf 1 1 1\nwhatever it is").diffuse == Material().diffuse);
}

// MTL's illumination models: 1 is "color on and ambient on", 2 adds "highlight on". Ka is named where it says something.
TEST_CASE("mtl: illum 1 has no highlight, and Ka is named where its hue is its own", "[01.illum]") {
    const Material matt = one("Kd .5 .1 .1\nKs 1 1 1\nNs 20\nmap_Ks b\nillum 1"),
                   shiny = one("Kd .5 .1 .1\nKs 1 1 1\nNs 20\nillum 2");
    CHECK(matt.specular == glm::vec3(0));
    CHECK_FALSE(matt.specular_map);
    CHECK(shiny.specular == glm::vec3(1));
    const std::vector<std::string> named{"Ka"}, none;
    CHECK(one("Ka .9 0 0\nKd .5 .1 .1").left_out == named);
    for (const char* plain : {"Ka 0 0 0\nKd .5 .1 .1", "Ka .8 .8 .8\nKd .5 .1 .1", "Ka .5 .1 .1\nKd .5 .1 .1",
                              "Ka .1 .02 .02\nKd .5 .1 .1", "Kd .5 .1 .1"})
        CHECK(one(plain).left_out == none);
}

TEST_CASE("mtl: maps and all their options") {
    const TextureMap map = one("map_Bump -bm 0.2 -o 1 2 3 -s 4 5 -t 0 0 0 -mm 0.1 2 -clamp on -imfchan l -blendu off "
                               "-blendv on -boost 2 -texres 512 -cc on -type sphere my file.png")
                               .bump_map;
    CHECK(map.file == fs::path("folder/my file.png"));
    CHECK(map.bump_multiplier == 0.2f);
    CHECK(map.offset == glm::vec3(1, 2, 3));
    CHECK(map.scale == glm::vec3(4, 5, 1));
    CHECK(map.base_gain == glm::vec2(0.1f, 2));
    CHECK(map.clamp);
    CHECK(map.channel == 'l');
    CHECK(one("bump -bm 0.2 file.png").bump_map.bump_multiplier == 0.2f);
    CHECK(one("map_Kd -o 1 2.png").diffuse_map.file == fs::path("folder/2.png"));
    CHECK(one("map_Kd -o 1 2 3").diffuse_map.file == fs::path("folder/3"));  // the last word is the file
    CHECK(one("map_Kd textures\\wood.png").diffuse_map.file == fs::path("folder/textures/wood.png"));
    CHECK(one("map_Kd C:\\Users\\me\\wood.png").diffuse_map.file == fs::path("folder/wood.png"));
    CHECK(one("map_Kd ../wood.png").diffuse_map.file == fs::path("wood.png"));
    CHECK(one("map_Kd -wood.png").diffuse_map.file == fs::path("folder/-wood.png"));
    using Names = std::vector<std::string>;
    CHECK(one("disp -s 2 2 2 h.png").left_out == Names{"-s and -o of disp"});
    CHECK(one("map_Pr -s 2 2 2 r.png\nmap_Pm m.png").left_out == Names{"-s and -o of map_Pm"});
    CHECK(one("disp h.png\nmap_Pr -s 2 2 2 r.png\nmap_Pm -s 2 2 2 m.png").left_out.empty());
    const Material m = one("map_Ka a\nmap_Ks b\nmap_Ke c\nmap_Ns d\nmap_d e\nnorm f\ndisp g\nmap_Pr h\nmap_Pm i");
    for (const TextureMap* each : {&m.ambient_map, &m.specular_map, &m.emissive_map, &m.shininess_map, &m.opacity_map,
                                   &m.normal_map, &m.displacement_map, &m.roughness_map, &m.metalness_map})
        CHECK(*each);
    CHECK_FALSE(m.diffuse_map);
}

TEST_CASE("mtl: errors with their line") {
    refuse("Kd 1 1 1\n", 1);
    refuse("# c\nnewmtl m\nKd red green blue\n", 3);
    refuse("newmtl m\nKd 1 1\n", 2);
    refuse("newmtl m\nNs\n", 2);
    refuse("newmtl m\nNs nan\n", 2);
    refuse("newmtl m\nNs 1e400\n", 2);
    refuse("newmtl m\nillum 11\n", 2);
    refuse("newmtl\n", 1);
    refuse("newmtl m\nmap_Kd\n", 2);
    refuse("newmtl m\nmap_Kd -bm x file.png\n", 2);
    refuse("newmtl m\nmap_Kd -clamp maybe file.png\n", 2);
    refuse("newmtl m\nmap_Kd -imfchan x file.png\n", 2);
    refuse(std::string("\0\1\2", 3), 1);
    CHECK(parse_mtl("", "test.mtl", "").empty());
    CHECK_THROWS_AS(load_mtl("/no/such/file.mtl"), InputError);
}

TEST_CASE("mtl: an OBJ finds its materials") {
    const FileFolder folder;
    write_file(folder / "my colours.mtl", "newmtl old brass\nKd 1 0.5 0\nmap_Kd my map.png\n");
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    write_file(folder / "a.obj",
               "mtllib my colours.mtl\n" + triangle + "usemtl old brass\nf 1 2 3\nusemtl gone\nf 3 2 1\nf 1 2 3\n");
    Model model = load_obj(folder / "a.obj");
    REQUIRE(model.materials.size() == 2);
    CHECK(model.materials[0].diffuse == glm::vec3(1, 0.5f, 0));
    CHECK(model.materials[0].diffuse_map.file == folder / "my map.png");
    CHECK(model.materials[1].name == "gone");
    REQUIRE(model.meshes.size() == 1);
    REQUIRE(model.meshes[0].parts.size() == 2);
    CHECK(model.meshes[0].parts[1].index_count == 6);
    // A missing file is a warning, for the shape is worth seeing; a malformed one is an error.
    write_file(folder / "b.obj", "mtllib nowhere.mtl\n" + triangle + "usemtl x\nf 1 2 3\n");
    CHECK(load_obj(folder / "b.obj").materials.size() == 1);
    write_file(folder / "bad.mtl", "newmtl m\nKd x\n");
    write_file(folder / "c.obj", "mtllib bad.mtl\n" + triangle + "f 1 2 3\n");
    CHECK_THROWS_AS(load_obj(folder / "c.obj"), InputError);
}

// Alias|Wavefront's Object Files: "mtllib filename1 filename2 . . ."; other programs write names with blanks, or quote them.
TEST_CASE("mtl: two names in mtllib, names with blanks and a byte order mark, by every loader", "[01.mtllib]") {
    const FileFolder folder;
    write_file(folder / "red paint.mtl", "newmtl red\nKd 1 0 0\n");
    write_file(folder / "green.mtl", "newmtl green\nKd 0 1 0\n");
    const std::string shape = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl green\nf 1 3 2\n";
    for (const char* names : {"red paint.mtl green.mtl", "green.mtl red paint.mtl", "\"red paint.mtl\" green.mtl",
                              "green.mtl\tred paint.mtl", "red paint.mtl\nmtllib green.mtl"})
        for (const char* mark : {"", "\xEF\xBB\xBF"})
            for (const std::string_view name : loader_names()) {
                CAPTURE(names, mark, name);
                write_file(folder / "a.obj", std::string(mark) + "mtllib " + names + "\n" + shape);
                const Model model = load_obj(folder / "a.obj", loader_from_name(name));
                bool red = false, green = false;
                for (const Mesh& mesh : model.meshes)
                    for (const Part& part : mesh.parts) {
                        const Material& m = model.materials[part.material];
                        red |= m.name == "red" && m.diffuse == glm::vec3(1, 0, 0);
                        green |= m.name == "green" && m.diffuse == glm::vec3(0, 1, 0);
                    }
                CHECK(red);
                CHECK(green);
            }
}

TEST_CASE("corpus: every MTL file is read or refused with its line") {
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(course_root() / "tests/01_obj/corpus/mtl")) {
        CAPTURE(entry.path());
        try {
            parse_mtl(read_file(entry.path()), "test.mtl", "");
        } catch (const InputError& error) { CHECK(std::string(error.what()).starts_with("test.mtl:")); }
        ++files;
    }
    CHECK(files >= 10);
}
