#include "11_fractals/ring_grid.h"

namespace lightwalk {

void add_grid_cells(std::vector<uint32_t>& indices, uint32_t cells, bool hollow) {
    const auto in_hole = [&](uint32_t i) { return i >= cells / 4 && i < cells - cells / 4; };
    for (uint32_t z = 0; z < cells; ++z)
        for (uint32_t x = 0; x < cells; ++x) {
            if (hollow && in_hole(x) && in_hole(z)) continue;
            const uint32_t a = z * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
            indices.insert(indices.end(), {a, c, b, b, c, d});
        }
}

void RingGrid::ensure(Gpu& gpu, uint32_t cells) {
    if (made_.is_current(cells)) return;
    std::vector<uint32_t> indices;
    add_grid_cells(indices, cells, false);
    whole_ = static_cast<uint32_t>(indices.size());
    add_grid_cells(indices, cells, true);
    hollow_ = static_cast<uint32_t>(indices.size()) - whole_;
    indices_ = gpu.upload("ring grid", indices);
}

void RingGrid::draw(Raster& pass, uint32_t rings) const {
    pass.draw_indexed(indices_, 0, whole_);
    if (rings > 1) pass.draw_indexed(indices_, whole_, hollow_, rings - 1, 1);
}

}  // namespace lightwalk
