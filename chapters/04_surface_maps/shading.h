// How surfaces are shaded, as a value.
#pragma once
#include "04_surface_maps/surface_pipelines.h"
#include "common/gpu/frame.h"

namespace lightwalk {

// [shading]
/// Pipelines by pass, and their bindings beside the drawing's modules. Null: the drawing's own pipelines.
struct Shading {
    const SurfacePipelines* opaque = nullptr;
    const Pipeline* seen = nullptr;                 ///< opaque surfaces in compute, for chapter 05's visibility buffer
    const SurfacePipelines* transparent = nullptr;  ///< blended surfaces; see see_through()
    const SurfacePipelines* depth = nullptr;        ///< depth only, before lights are sorted into tiles
    /// Chapter 06's G-buffer: `stored` writes it, `rest` adds light other than the lights', with emission and ambient
    /// light.
    const SurfacePipelines* stored = nullptr;
    const SurfacePipelines* rest = nullptr;
    std::vector<With> with{};
    std::vector<Resource> reads{};
};

/// Pipelines for Shading::transparent: the fragment shader with TRANSPARENT, which writes alpha and cuts no holes.
SurfacePipelines see_through(const char* fragment, Macros macros = {});
// [/shading]

}  // namespace lightwalk
