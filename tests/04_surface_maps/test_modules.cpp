// Modules of earlier chapters in a chapter that has never heard of theirs: a METHOD and knobs of its own.
#include "03_attenuation/lights.h"
#include "04_surface_maps/maps.h"
#include "catch.h"
#include "common/base/files.h"
#include "common/gpu/pipeline.h"

using namespace lightwalk;

namespace {

constexpr const char* foreign = "../tests/04_surface_maps/data/foreign.frag";

struct Foreign : Module {
    Choice method{*this, "method", {"dark", "dim", "bright"}, "bright", "none that a module knows"};
    Knob<float> strength{*this, "strength", 1.0f, {0.0f, 2.0f}, "Maps has one, too"};
    Knob<glm::vec3> tint{*this, "tint", glm::vec3(1.0f), {glm::vec3(0.0f), glm::vec3(1.0f)}, "a colour"};
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    const Pipeline pipeline = graphics({.vertex = "04_surface_maps/surface.vert", .fragment = foreign});

    std::vector<FlatShader> flat() const {
        Macros all = macros();
        all.add(maps.macros());
        all.add(lights.macros());
        return flatten_stages(pipeline, all);
    }
    std::vector<Binding> bindings() const {
        CompiledStages stages = compile_stages(pipeline, flat());
        for (const auto& spirv : stages.spirv) CHECK(validate_spirv(spirv) == "");
        return assign_bindings(stages);
    }
    bool binds(const char* name) const {
        for (const Binding& binding : bindings())
            if (binding.name == name) return true;
        return false;
    }
};

}  // namespace

TEST_CASE("modules compile under a foreign METHOD and beside foreign knobs, in every variant of theirs") {
    Foreign chapter;
    for (const std::string& own : chapter.method.options) {
        chapter.method.set(own);
        for (const std::string& method : chapter.maps.method.options) {
            chapter.maps.method.set(method);
            CHECK(chapter.binds("maps"));
        }
        for (const std::string& method : chapter.lights.method.options) {
            chapter.lights.method.set(method);
            CHECK(chapter.binds("lights_object_ends") == (method == "per_object"));
            CHECK(chapter.binds("lights_masks") == (method == "tiled" || method == "clustered"));
        }
        for (const std::string& falloff : chapter.lights.falloff.options) {
            chapter.lights.falloff.set(falloff);
            CHECK(chapter.binds("knobs"));
        }
    }
}

TEST_CASE("a shader that asks for the macro of a module it was not given does not compile") {
    const Foreign chapter;
    Macros without_lights = chapter.macros();
    without_lights.add(chapter.maps.macros());
    CHECK_THROWS_WITH(flatten_stages(chapter.pipeline, without_lights),
                      Catch::Matchers::Contains("nobody defines LIGHTS_FALLOFF") &&
                          Catch::Matchers::Contains("shaders/03_attenuation/lighting.glsl:"));
}

TEST_CASE("what only the chapter's own shaders name makes no variant of a module's") {
    Foreign chapter;
    const auto vertex = [&] { return chapter.flat()[0].text; };
    const std::string before = vertex();
    chapter.method.set("dark");
    chapter.maps.method.set("flat");
    chapter.lights.method.set("tiled");
    CHECK(vertex() == before);
    CHECK(names_macro("#if A_METHOD == 1", "A_METHOD"));
    CHECK_FALSE(names_macro("#if A_METHOD == 1", "METHOD"));
}
