#include "14_environment/backdrop.h"

#include "14_environment/backdrop_data.h"

namespace lightwalk {

void Backdrop::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!scene_->environment || canvas.has_color()) return;
    const Image& picture = *scene_->environment;
    const ImageView behind = canvas.color_overwritten();
    frame.compute("backdrop", {.reads = {picture}, .writes = {behind}}, [&](Compute& pass) {
        pass.use(fill_).set("picture", picture).set("rays", view_rays(view)).set("result", behind);
        pass.set("environment_scale", environment_scale(*scene_, light_.intensity, light_.turn_deg));
        pass.set("now", BackdropNow{.ground_y = ground_y,
                                    .camera_m = camera_m,
                                    .has_ground = ground.is("projected") ? 1u : 0u,
                                    .level = level});
        pass.dispatch_threads(glm::uvec2(behind.size()));
    });
}

}  // namespace lightwalk
