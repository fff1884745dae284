// White furnace: radiance 1 from everywhere, in which no material may send out more than arrives.
#include <set>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "14_environment/lit_around.h"
#include "catch.h"

using namespace lightwalk;

namespace {

struct InFurnace : OnModules {
    ImageLight light{owner, "environment"};
    LitAround objects{owner, "objects", light};

    Scene scene;

    /// Its objects without lights and emission, in an ambient light of 1.
    void load(SceneFile file) {
        file.lights.clear();
        file.environment = {};
        file.ambient = glm::vec3(1);
        for (SceneObject& object : file.objects) {
            object.material.emissive = glm::vec3(0);
            object.material.maps.erase("emissive");
        }
        scene.load(gpu, file, [](const auto& path) { return load_model(path, Loader::parallel); });
    }

    /// As the scene's camera sees them. The background is 1, too.
    ImageRgb picture() {
        owner.prepare_all(gpu, scene);
        const View view = view_of(scene.file.camera, {96, 54});
        begin(view.size);
        light.record(frame, scene);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(1));
        lightwalk::draw(frame, view, canvas, {objects});
        frame.end();
        return read_linear(gpu, frame.hdr);
    }

    static float brightest(const ImageRgb& seen) {
        float most = 0;
        for (const glm::vec3& p : seen.pixels) most = std::max({most, p.r, p.g, p.b});
        return most;
    }
};

}  // namespace

TEST_CASE_METHOD(InFurnace, "in a white furnace no material of any scene sends out more than arrives",
                 "[14.furnace][14.furnaces]") {
    // A scene for each model and material of its own loaded by chapters 01 to 19.
    std::set<std::string> drawn;
    for (const auto& entry : std::filesystem::directory_iterator(find_asset("scenes"))) {
        SceneFile file = read_scene(entry.path());
        bool is_new = false, is_later = false;
        for (const SceneObject& object : file.objects) {
            SceneFile alone;
            alone.objects = {{.name = "x", .parent = {}, .model = object.model, .material = object.material}};
            is_new = drawn.insert(scene_text(alone)).second || is_new;
            // Height maps, volumes and lathed models are other chapters', with materials of their own.
            is_later = is_later ||
                       (object.model != "" && object.model.extension() != ".obj" && object.model.extension() != ".glb");
        }
        if (!is_new || is_later) continue;
        load(file);
        for (const char* method : {"dominant", "multiscatter"}) {
            light.method.set(method);
            const float most = brightest(picture());
            INFO(entry.path().filename() << " " << method << ": " << most);
            CHECK(most < 1.03f);
        }
    }
    CHECK(drawn.size() > 50);
}

TEST_CASE_METHOD(InFurnace, "in a white furnace paint of white flakes or white pigment sends out less than arrives",
                 "[14.furnace_paint][14.furnaces]") {
    load(read_scene(find_asset("scenes/car.json")));
    objects.paint.color.value = objects.paint.edge_color.value = objects.paint.flake_color.value = glm::vec3(1);
    for (const float flakes : {0.0f, 0.5f, 1.0f})
        for (const float roughness : {0.1f, 0.45f, 1.0f}) {
            objects.paint.flakes.value = flakes;
            objects.paint.flake_roughness.value = roughness;
            const float most = brightest(picture());
            INFO("flakes " << flakes << ", roughness " << roughness << ": " << most);
            CHECK(most < 1.03f);
        }
}
