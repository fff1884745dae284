// Shared by the tests of the whole of skin: a scene, its lights, and its picture in linear light.
#pragma once
#include <cmath>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "05_shadow_maps/shadow.h"
#include "12_skin/skin.h"
#include "common/app/environment.h"

namespace lightwalk {

struct OnHead : OnModules {
    Skin skin{owner, "skin"};
    Maps maps{owner, "maps"};
    Lights lights{owner, "lights"};
    Shadow shadow{owner, "shadow"};
    SceneRays rays{owner, "rays"};
    EnvironmentLight environment{owner, "environment"};
    Scene scene;

    OnHead() {
        maps.method.set("flat");
        lights.method.set("every_light");
        shadow.resolution.value = 256;
        skin.sky_size.value = 32;
        skin.sky_rays.value = 4;
    }

    void load(SceneFile file) {
        scene.load(gpu, std::move(file), [](const auto& path) { return load_model(path, Loader::parallel); });
        maps.prepare(gpu, scene);
        maps.surface.prepare(gpu, scene);
        skin.prepare(gpu, scene);
        rays.build(gpu, scene);
        shadow.prepare(gpu, scene);
    }

    ImageRgb draw(glm::uvec2 size) {
        const Camera& camera = scene.file.camera;
        begin(size);
        frame.crop = {.whole = size, .origin = {0, 0}, .shift = {0, 0}};
        const View view = view_of(camera, size);
        look_from(view, frame);
        lights.update(frame, scene, scene.file.lights);
        shadow.record(frame, scene, lights, view);
        rays.record(frame, scene);
        environment.record(frame, scene);
        const Skin::Lit lit{maps, rays, {lights, shadow, environment}};
        skin.record(frame, scene, view, lit);
        Canvas canvas(frame.hdr, frame.depth);
        skin.draw(frame, scene, canvas, lit);
        skin.finish(frame, view, canvas);
        frame.end();
        return read_linear(gpu, frame.hdr);
    }

    bool did(const char* pass) const {
        for (const PassTime& time : frame.times)
            if (time.name == pass) return true;
        return false;
    }
};

inline SceneFile portrait() {
    SceneFile file = read_scene(find_asset("scenes/portrait.json"));
    file.objects.front().material.maps.clear();
    return file;
}

/// A white ball of a head's size, and light from everywhere.
inline SceneFile furnace(float radiance) {
    SceneFile file;
    SceneObject& ball = file.objects.emplace_back();
    ball.name = "ball";
    ball.model = "models/sphere.obj";
    ball.scale = glm::vec3(0.2f);
    ball.material.diffuse = glm::vec3(1);
    ball.material.specular = glm::vec3(1, 0.3f, 0);
    file.camera = {.position = {0, 0, 0.5f}, .target = {0, 0, 0}, .fov_y_rad = 0.5f};
    file.ambient = glm::vec3(radiance);
    return file;
}

}  // namespace lightwalk
