#include "03_attenuation/lights.h"

#include <fmt/core.h>

namespace lightwalk {

void Lights::update(Frame& frame, const Scene& scene, const LightList& lights) {
    buffer_.update(frame, lights);
    update_objects(frame, scene);
}

void Lights::update(Frame& frame, const Scene& scene, const std::vector<Light>& lights) {
    buffer_.update(frame, lights);
    update_objects(frame, scene);
}

void Lights::update_objects(Frame& frame, const Scene& scene) {
    if (method.is("per_object")) object_lights_.update(frame, scene, buffer_, ends_at());
}

void Lights::record(Frame& frame, const Scene& scene, const View& view, const ImageView& depth) {
    grid_.set_view(view, scene.bounds, method.is("tiled") ? LightGrid::Cells::tiles : LightGrid::Cells::clusters,
                   slices, buffer_.lights().size(), ends_at());
    if (has_cells()) grid_.record(frame, *this, depth);
}

std::vector<std::string> Lights::status() const {
    if (!buffer_.rebuilds) return {};
    return {fmt::format("{} lights, packed {}×", buffer_.lights().size(), buffer_.rebuilds)};
}

std::vector<Resource> Lights::reads() const {
    std::vector<Resource> reads{buffer_.buffer};
    if (has_cells() && grid_.masks) reads.insert(reads.end(), {grid_.masks, grid_.groups});
    return reads;
}

void Lights::bind(Pass& pass) const {
    pass.set_if_present("lights_data", buffer_.buffer);
    pass.set_if_present("lights_grid", grid_.view);
    if (method.is("per_object")) {
        pass.set_if_present("lights_object_ends", object_lights_.ends);
        pass.set_if_present("lights_of_objects", object_lights_.lights);
    }
    if (has_cells()) {
        pass.set_if_present("lights_masks", grid_.masks);
        pass.set_if_present("lights_groups", grid_.groups);
    }
}

}  // namespace lightwalk
