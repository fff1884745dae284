// How surfaces are shaded, as a value.
#pragma once
#include "04_surface_maps/surface_pipelines.h"
#include "common/gpu/frame.h"

namespace lightwalk {

// [shading]
/// Pipelines of each pass that draws surfaces, and their bindings beside the drawing's own modules. Null: the drawing's
/// own pipelines.
struct Shading {
    const SurfacePipelines* opaque = nullptr;
    const Pipeline* seen = nullptr;                 ///< opaque's light in compute, for chapter 05's visibility buffer
    const SurfacePipelines* transparent = nullptr;  ///< the same with blending: see_through()
    const SurfacePipelines* depth = nullptr;        ///< alone, before light is sorted into tiles
    /// For chapter 06's G-buffer: `stored` writes the inputs of the lights, `rest` adds all other light once per pixel,
    /// emission and ambient light included.
    const SurfacePipelines* stored = nullptr;
    const SurfacePipelines* rest = nullptr;
    std::vector<With> with{};
    std::vector<Resource> reads{};
};

/// For Shading::transparent: the fragment shader with TRANSPARENT, which writes alpha and cuts nothing out.
SurfacePipelines see_through(const char* fragment, Macros macros = {});
// [/shading]

}  // namespace lightwalk
