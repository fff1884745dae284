#include "10_atmosphere/height_fog.h"

namespace lightwalk {

HeightFog::HeightFog(Module& owner, std::string name) : Drawing(owner, std::move(name), "fog") {}

void HeightFog::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (method.is("none")) return;
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    const glm::vec3 to_sun = scene_ ? scene_->sun().to_sun : Sun().to_sun;
    frame.compute("height fog", {.reads = {hdr, depth}, .writes = {hdr}, .with = {*this}}, [&](Compute& pass) {
        pass.use(fog_).set("result", hdr).set("depth", depth, nearest_clamp);
        pass.set("rays", view_rays(view)).set("fog_sun", glm::vec4(to_sun, sky_m));
        pass.dispatch_threads(view.size);
    });
}

}  // namespace lightwalk
