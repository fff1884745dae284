#include "19_ambiance/street.h"

#include <fmt/core.h>

#include "01_obj/camera_view.h"
#include "common/app/knob_scope.h"

namespace lightwalk {

// [street]
// Strips of equal width, each a part of the whole picture.
void Street::draw_view(Frame& frame, const View& view, Canvas& canvas) {
    static const char* const methods[] = {"forward", "fat", "packed", "tiled"};
    for (uint32_t i = 0; i < 4; ++i) {
        const KnobScope method(objects.gbuffer.method, methods[i]);
        const uint32_t first = view.size.x * i / 4, end = std::max(view.size.x * (i + 1) / 4, first + 1);
        Crop crop = view.crop;
        crop.origin.x += first;
        View strip = view_of(view.camera, {end - first, view.size.y}, crop);
        strip.id = views_.of(view.id, i);
        colors_[i].fit(frame.gpu.device, {.name = fmt::format("strip {}", i), .size = strip.size});
        depths_[i].fit(frame.gpu.device,
                       {.name = fmt::format("strip {} depth", i), .format = VK_FORMAT_D32_SFLOAT, .size = strip.size});
        Canvas own(colors_[i], depths_[i], canvas.background());
        draw(frame, strip, own, drawings());
    }
    const ImageView joined = canvas.color_overwritten();
    frame.compute("strips", {.reads = {colors_[0], colors_[1], colors_[2], colors_[3]}, .writes = {joined}},
                  [&](Compute& pass) {
                      pass.use(join_);
                      for (int i = 0; i < 4; ++i) pass.set(fmt::format("strip_{}", i), colors_[i], nearest_clamp);
                      pass.set("result", joined).dispatch_threads(view.size);
                  });
}
// [/street]

}  // namespace lightwalk
