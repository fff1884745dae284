#include "14_environment/backdrop.h"

#include "14_environment/backdrop_data.h"

namespace lightwalk {

void Backdrop::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!scene_->environment || canvas.has_color()) return;
    const Image& picture = *scene_->environment;
    const EnvironmentScale turn = environment_scale(*scene_, light_.intensity, light_.turn_deg);
    const bool has_ground = ground.is("projected"), shaded = has_ground && !scene_->items.empty();
    if (shaded) shadow.record(frame, *scene_, cut_by_, turn, ground_y);
    const ImageView behind = canvas.color_overwritten();
    const ImageView arriving = shaded ? ImageView(shadow.arriving) : ImageView(picture).mip(0);
    frame.compute("backdrop", {.reads = {picture, arriving}, .writes = {behind}}, [&](Compute& pass) {
        pass.use(fill_).set("picture", picture).set("rays", view_rays(view)).set("result", behind);
        pass.set("environment_scale", turn).set("arriving", arriving, linear_clamp);
        pass.set("now", BackdropNow{.ground_y = ground_y,
                                    .camera_m = camera_m,
                                    .radius_m = radius_m,
                                    .has_ground = has_ground ? 1u : 0u,
                                    .level = level,
                                    .map_corner =
                                        shaded ? shadow.state().corner : glm::vec2(1e9f),  // nothing is within the map
                                    .map_extent = shaded ? shadow.state().extent : glm::vec2(1.0f)});
        pass.dispatch_threads(glm::uvec2(behind.size()));
    });
}

}  // namespace lightwalk
