#include "05_shadow_maps/moments.h"

#include <cmath>
#include <utility>

namespace lightwalk {

Blur blur_of(int radius, float exponent, float exponent_negative) {
    Blur blur{.radius = radius, .exponent = exponent, .exponent_negative = exponent_negative};
    float sum = 0;
    for (int i = 0; i <= radius; ++i) {
        const float t = 2.5f * static_cast<float>(i) / (static_cast<float>(radius) + 0.5f);
        blur.weights[i] = std::exp(-0.5f * t * t);
        sum += (i > 0 ? 2.0f : 1.0f) * blur.weights[i];
    }
    blur.weights[0] = 1;
    for (int i = 1; i <= radius; ++i) {
        blur.weights[i] /= sum;
        blur.weights[0] -=
            2.0f * blur.weights[i];  // the remainder: the sum must be 1, since the moments' noise depends on it
    }
    return blur;
}

bool MomentMaps::ensure(Gpu& gpu, const Image& map, VkFormat format) {
    const Image::Desc wanted{.name = map.desc.name + " moments",
                             .format = format,
                             .size = map.desc.size,
                             .mips = full_mip_count(map.desc.size),
                             .layers = map.desc.layers,
                             .kept = true};
    if (!moments.ensure(gpu.device, wanted)) return false;
    between_ = Image(gpu.device, {.name = wanted.name + " between", .format = format, .size = wanted.size});
    return true;
}

// [blur]
// Along u, then along v, then halved to the last mip; each step waits for the one before.
void MomentMaps::record(Frame& frame, const ImageView& layer, const Buffer& views, uint32_t view, Blur blur,
                        const Macros& macros) {
    const ImageView into = ImageView(moments).layer(layer.first_layer);
    blur.view = view;
    const uint32_t size = moments.desc.size.x;
    const glm::uvec3 groups((size + 63) / 64, (size + 3) / 4, 1);
    frame.compute("blur", {.reads = {layer, views, between_}, .writes = {between_, into.mip(0)}}, [&](Compute& pass) {
        pass.use(first_, macros).set("blur", blur).set("shadow_views", views);
        pass.set("source", layer, nearest_clamp).set("result", between_).dispatch(groups).wait();
        pass.use(second_, macros)
            .set("blur", blur)
            .set("shadow_views", views)
            .set("source", between_, nearest_clamp)
            .set("result", into.mip(0))
            .dispatch(groups);
    });
    frame.compute("moment_mips", {.reads = {into}, .writes = {into}}, [&](Compute& pass) {
        for (uint32_t mip = 1; mip < moments.desc.mips; ++mip) {
            pass.use(halve_).set("source", into.mip(mip - 1), nearest_clamp).set("result", into.mip(mip));
            pass.dispatch_threads(glm::uvec2(std::max(size >> mip, 1u))).wait();
        }
    });
}
// [/blur]

}  // namespace lightwalk
