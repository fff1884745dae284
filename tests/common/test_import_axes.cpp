// COLLADA: units, axes and materials as its specification says. FBX and 3MF are in assets/conformance.
#include "import_fixture.h"

using namespace lightwalk;

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
