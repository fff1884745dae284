#include "15_terrain_water/mirror.h"

#include "01_obj/camera_view.h"
#include "15_terrain_water/exercises.h"

namespace lightwalk {

Camera mirrored_camera(const Camera& camera, float level_m) {
    Camera mirrored = camera;
    mirrored.position.y = 2.0f * level_m - camera.position.y;
    mirrored.target.y = 2.0f * level_m - camera.target.y;
    mirrored.up.y = -camera.up.y;
    return mirrored;
}

// [mirror_record]
void Mirror::record(Frame& frame, const View& view, float level_m, const Drawings& drawings) {
    const Drawings solid = of_phases({Phase::backdrop, Phase::opaque}, drawings);
    const Drawings air = of_phases({Phase::sky, Phase::air, Phase::fog}, drawings);
    const glm::uvec2 size = glm::max(glm::uvec2(glm::vec2(view.size) * scale.value), 1u);
    const auto fit = [&](Image& image, const char* name, VkFormat format) {
        image.ensure(frame.gpu.device, {.name = path() + name, .format = format, .size = size});
    };
    fit(color_, " color", VK_FORMAT_R16G16B16A16_SFLOAT);
    fit(oblique_, " oblique depth", VK_FORMAT_D32_SFLOAT);
    fit(depth_, " depth", VK_FORMAT_D32_SFLOAT);

    // 1. Seen from below: the same part of the picture, counted from the other edge.
    const glm::vec2 shrunk = glm::vec2(size) / glm::vec2(view.size);
    Crop crop = view.crop;
    crop.whole = glm::max(glm::uvec2(glm::vec2(crop.whole) * shrunk), 1u);
    crop.origin.x = view.crop.whole.x - view.crop.origin.x - view.size.x;
    crop.origin = glm::uvec2(glm::vec2(crop.origin) * shrunk);
    crop.shift = glm::vec2(-crop.shift.x, crop.shift.y) * shrunk;
    View plain = view_of(mirrored_camera(view.camera, level_m), size, crop);
    plain.id = views_.of(view.id);
    plain.sun_disc = false;  // water adds the sun's glitter
    View clipped = plain;
    clipped.view_projection = mirror_view(view.view_projection, level_m);

    // 2. Opaque surfaces, clipped at the water. Their light comes through the air, which is drawn later.
    update(frame, in_order(drawings));
    Canvas below(color_, oblique_);
    draw_opaque(frame, clipped, below, solid);
    below.depth(frame);

    // 3. Its depth as the air wants it. The third row of the matrix is the fourth less `scale` times the water's plane.
    const glm::mat4 rows = glm::transpose(clipped.view_projection);
    const struct { float level_m, scale; } oblique{level_m, rows[3].y - rows[2].y};
    frame.raster("plain depth", {.depth = clear(depth_, 0.0f), .reads = {oblique_}}, [&](Raster& pass) {
        pass.use(plain_depth_).set("oblique_depth", oblique_, nearest_clamp).set("oblique", oblique);
        pass.set("mirror_rays", view_rays(plain)).draw(3);
    });

    // 4. The sky behind it and the air in front; then transparent surfaces, always back to front by object.
    Canvas canvas(color_, depth_);
    canvas.color_overwritten();
    canvas.depth_overwritten();
    if (!air.empty()) draw_opaque(frame, plain, canvas, air);
    draw_transparent(frame, clipped, below, solid);
}
// [/mirror_record]

}  // namespace lightwalk
