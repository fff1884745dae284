// FBX, COLLADA and 3MF: units, axes, and materials as their specifications say.
#include "import_fixture.h"

using namespace lightwalk;

namespace {

std::string fbx(int up, int front, int front_sign, double centimetres) {
    const auto setting = [](const char* name, const char* types, auto value) {
        return fmt::format("P: \"{}\", {}, \"\",{}\n", name, types, value);
    };
    const char *whole = R"("int", "Integer")", *real = R"("double", "Number")";
    return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\nFBXVersion: "
           "7400\n}\nGlobalSettings: "
           "{\nVersion: 1000\nProperties70: {\n" +
           setting("UpAxis", whole, up) + setting("UpAxisSign", whole, 1) + setting("FrontAxis", whole, front) +
           setting("FrontAxisSign", whole, front_sign) + setting("CoordAxis", whole, 0) +
           setting("CoordAxisSign", whole, 1) + setting("UnitScaleFactor", real, centimetres) +
           "}\n}\nObjects: {\nGeometry: 100, \"Geometry::\", \"Mesh\" {\nVertices: *9 {\na: 0,0,0,100,0,0,0,0,100\n}\n"
           "PolygonVertexIndex: *3 {\na: 0,1,-3\n}\n}\nModel: 200, \"Model::one\", \"Mesh\" {\nVersion: 232\n}\n}\n"
           "Connections: {\nC: \"OO\",200,0\nC: \"OO\",100,200\n}\n";
}

}  // namespace

// The axes that 3ds Max, Blender (z is up, -y ahead) and Maya (y is up, z ahead) write; a unit is UnitScaleFactor cm.
TEST_CASE("FBX: the axis that is up, and the unit") {
    const auto top = [](const Model& model) {
        const Bounds box = model_bounds(model);
        return box.upper - box.lower;
    };
    CHECK(glm::length(top(model_of("z_up.fbx", fbx(2, 1, -1, 1))) - glm::vec3(1, 1, 0)) < 1e-6f);
    CHECK(glm::length(top(model_of("y_up.fbx", fbx(1, 2, 1, 1))) - glm::vec3(1, 0, 1)) < 1e-6f);
    CHECK(glm::length(top(model_of("inches.fbx", fbx(1, 2, 1, 2.54))) - glm::vec3(2.54f, 0, 2.54f)) < 1e-5f);
    CHECK(model_bounds(model_of("z_up.fbx", fbx(2, 1, -1, 1))).upper.y > 0.99f);  // not upside down
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

// 3MF core specification, 3.4: z is up, and the unit is an attribute of the model. Two inches wide, three high.
TEST_CASE("3MF: the axis that is up, and the unit") {
    const Model model = import_model(course_root() / "assets/conformance/inches.3mf");
    const Bounds box = model_bounds(model);
    CHECK(glm::length(box.upper - glm::vec3(0.0508f, 0.0762f, 0)) < 1e-6f);
    CHECK(model.materials.at(model.meshes.at(0).parts.at(0).material).diffuse == glm::vec3(1, 0, 0));
    CHECK(left_out_text(model) == "colours of triangles");
}
