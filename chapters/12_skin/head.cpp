#include "12_skin/head.h"

namespace lightwalk {

Head::Head(Module& owner, std::string name, LitScene& objects, EnvironmentLight& environment)
    : Drawing(owner, std::move(name)),
      skin(owner, "skin"),
      rays(owner, "rays"),
      backdrop(owner, "backdrop", 4.5f, {0.0f, 8.0f},
               "which level of the environment is seen behind: more is blurrier"),
      objects_(objects),
      environment_(environment) {}

void Head::update(Frame& frame) {
    objects_.update_once(frame);
    rays.record(frame, *scene_);
    environment_.record(frame, *scene_);
}

void Head::draw(Frame& frame, const View& view, Canvas& canvas) {
    // 1. Depth from the lights that cast shadows. Texels of the skin's map are in no tile: loops go over all lights.
    objects_.record_shadows(frame, view);
    const Skin::Lit lit{objects_.maps, rays, {objects_.lights, objects_.shadow, environment_}};

    // 2. The light on the skin's map, and how it spreads there.
    skin.record(frame, *scene_, view, lit);

    // 3. The surroundings, unless something was drawn; then the head.
    if (!canvas.has_color() && !canvas.has_depth()) {
        const ImageView behind = canvas.color_overwritten();
        frame.compute("backdrop", {.writes = {behind}, .with = {environment_}}, [&](Compute& pass) {
            pass.use(backdrop_).set("backdrop", backdrop.value).set("result", behind).dispatch_threads(view.size);
        });
    }
    skin.draw(frame, *scene_, canvas, lit, shown);
    skin.finish(frame, view, canvas);
}

}  // namespace lightwalk
