#include "14_environment/probe.h"

#include "01_obj/camera_view.h"

namespace lightwalk {

SceneProbe::SceneProbe(Module& owner, std::string name) : Module(owner, std::move(name), "probe") {}

Camera face_camera(uint32_t face, glm::vec3 center, float near_m, float far_m) {
    constexpr glm::vec3 forward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    constexpr glm::vec3 up[] = {{0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
    return {.position = center,
            .target = center + forward[face],
            .up = up[face],
            .fov_y_rad = glm::half_pi<float>(),
            .near_m = near_m,
            .far_m = far_m};
}

// [face]
void SceneProbe::draw_face(Frame& frame, const Scene& scene, LightCubes& cubes, uint32_t face, const Draw& draw) {
    const glm::uvec2 size = cubes.radiance.desc.size;
    color_.ensure(frame.gpu.device, {.name = path() + " color", .size = size});
    depth_.ensure(frame.gpu.device, {.name = path() + " depth", .format = VK_FORMAT_D32_SFLOAT, .size = size});
    View view = view_of(face_camera(face, center, near_m, scene.file.camera.far_m), size);
    view.id = views_.of(0, face);
    view.sun_disc = !distant;  // the scene's sun lights by itself
    {
        const ViewScope scope(frame, view);
        Canvas canvas(color_, depth_, glm::vec4(scene.file.background, 1.0f));
        draw(view, canvas);
    }
    const ImageView result = cubes.radiance.face(face).mip(0);
    frame.compute("probe face", {.reads = {color_}, .writes = {result}}, [&](Compute& pass) {
        pass.use(to_face_).set("picture", color_, nearest_clamp).set("face", result).dispatch_threads(size);
    });
}
// [/face]

// The probe depends on the knobs of the drawings and of their inputs, and on time if one of these is animated.
void SceneProbe::record(Frame& frame, const Scene& scene, ImageLight& light, const Drawings& drawings) {
    const Drawings drawn = in_order(distant ? of_phases({Phase::sky, Phase::air}, drawings) : drawings);
    std::vector<const Module*> dependencies;
    for (const Drawing& drawing : drawn)
        for (const Module* module : drawing.dependencies()) dependencies.push_back(module);
    record(frame, scene, light, dependencies,
           [&](const View& view, Canvas& canvas) { draw(frame, view, canvas, drawn); });
}

void SceneProbe::record(Frame& frame, const Scene& scene, ImageLight& light, World& world) {
    record(frame, scene, light, {&world},
           [&](const View& view, Canvas& canvas) { world.draw_light(frame, view, canvas); });
}

void SceneProbe::record(Frame& frame, const Scene& scene, ImageLight& light,
                        const std::vector<const Module*>& dependencies, const Draw& draw) {
    drawn_faces = 0;
    if (update.is("off")) return;
    Hash knobs;
    knobs.add(hash_of(epoch(), light.epoch()));
    bool animated = false;
    for (const Module* module : dependencies) {
        knobs.add(module->epoch());
        animated |= module->any_animated();
    }
    const bool first = !made_;
    // Where the sky alone is drawn, objects may move.
    const bool changed = !made_.is_current(distant ? 0 : scene.epoch, knobs.value,
                                           animated ? std::optional(frame.time_s) : std::nullopt);
    if (update.is("moved") && !changed) {
        light.use(light.drawn);
        return;
    }
    // The first time there is nothing in the other faces.
    const bool one = update.is("face") && !first;
    for (uint32_t face = 0; face < 6; ++face)
        if (!one || face == next_face_) {
            draw_face(frame, scene, light.drawn, face, draw);
            ++drawn_faces;
        }
    if (one) next_face_ = (next_face_ + 1) % 6;
    light.record_drawn(
        frame, {.box_lower = lower, .has_box = box && !distant ? 1u : 0u, .box_upper = upper, .box_center = center});
}

}  // namespace lightwalk
