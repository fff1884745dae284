#include "10_atmosphere/height_fog.h"

#include "common/scene/view.h"

namespace lightwalk {

void HeightFog::record(Frame& frame, const Image& hdr, const Image& depth, const Camera& camera, glm::vec3 to_sun,
                       float sky_m) {
    if (method.is("none")) return;
    frame.compute("height fog", {.reads = {hdr, depth}, .writes = {hdr}, .with = {*this}}, [&](Compute& pass) {
        pass.use(fog_).set("result", hdr).set("depth", depth, nearest_clamp);
        pass.set("rays", view_rays(camera, frame)).set("fog_sun", glm::vec4(to_sun, sky_m));
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
