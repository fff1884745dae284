#include "14_environment/probe.h"

#include <fmt/core.h>

#include "01_obj/camera_view.h"
#include "common/app/settings.h"

namespace lightwalk {

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
void SceneProbe::draw_face(Frame& frame, const Scene& scene, LightCubes& cubes, uint32_t face,
                           const Drawings& drawings) {
    const glm::uvec2 size = cubes.radiance.desc.size;
    color_.fit(frame.gpu.device, {.name = path() + " color", .size = size});
    depth_.fit(frame.gpu.device, {.name = path() + " depth", .format = VK_FORMAT_D32_SFLOAT, .size = size});
    View view = view_of(face_camera(face, center, near_m, scene.file.camera.far_m), size);
    view.id = 0x14000000u + face;
    {
        const ViewScope scope(frame, view);
        Canvas canvas(color_, depth_, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, drawings);
    }
    const ImageView result = cubes.radiance.face(face).mip(0);
    frame.compute("probe face", {.reads = {color_}, .writes = {result}}, [&](Compute& pass) {
        pass.use(to_face_).set("picture", color_, nearest_clamp).set("face", result).dispatch_threads(size);
    });
}
// [/face]

// [record]
void SceneProbe::record(Frame& frame, const Scene& scene, ImageLight& light, const Drawings& drawings) {
    drawn_faces = 0;
    if (update.is("off")) return;
    // Any knob of the chapter may change what is drawn; and where something is animated besides the objects, time does. Where
    // the sky alone is drawn, objects may move.
    const std::string now = fmt::format("{} {} {} {}", distant ? 0 : scene.placed, Exercises::version(),
                                        owner_.any_animated() ? frame.time_s : 0.0f, settings_of(owner_));
    const bool first = made_.empty();
    if (update.is("moved") && now == made_) {
        light.use(light.drawn);
        return;
    }
    made_ = now;
    // The first time there is nothing in the other faces.
    const bool one = update.is("face") && !first;
    for (uint32_t face = 0; face < 6; ++face)
        if (!one || face == next_face_) draw_face(frame, scene, light.drawn, face, drawings), ++drawn_faces;
    if (one) next_face_ = (next_face_ + 1) % 6;
    light.record_drawn(
        frame, {.box_lower = lower, .has_box = box && !distant ? 1u : 0u, .box_upper = upper, .box_center = center});
}
// [/record]

}  // namespace lightwalk
