// Triangles of a grid of rings around a middle, each of cells twice as large as the one within.
#pragma once
#include <vector>

#include "common/base/epoch.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Two triangles for each cell of a grid, counter-clockwise from above; `hollow`: without the middle half of each side.
/// Vertex (x, z) has the number z * (cells + 1) + x.
void add_grid_cells(std::vector<uint32_t>& indices, uint32_t cells, bool hollow);

/// The innermost ring is whole, the others are hollow. Shaders place the vertices: 11_fractals/ring_grid.glsl.
class RingGrid {
  public:
    /// Uploads the triangles, where the number of cells along a side of a ring (a multiple of 4) is another than before.
    void ensure(Gpu& gpu, uint32_t cells);

    /// gl_InstanceIndex is the ring's number, from 0.
    void draw(Raster& pass, uint32_t rings) const;

    /// For shaders that look triangles up: three numbers of vertices each, of the whole ring and then, from the index
    /// hollow_from() on, of the hollow ones.
    const Buffer& indices() const { return indices_; }
    uint32_t hollow_from() const { return whole_; }

    uint64_t triangles(uint32_t rings) const { return (whole_ + uint64_t(rings - 1) * hollow_) / 3; }

  private:
    Buffer indices_;
    Fingerprint made_;  ///< cells
    uint32_t whole_ = 0, hollow_ = 0;
};

}  // namespace lightwalk
