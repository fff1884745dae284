// A material's maps: which of them are in use, and their smaller levels.
#pragma once
#include "04_surface_maps/levels.h"
#include "common/app/knob.h"
#include "common/image/image.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// One switch for each texture slot. A slot that is off, or that a material has no texture for, is compiled out.
struct MapSwitches {
    Knob<bool> diffuse{"diffuse", true, "colour textures"};
    Knob<bool> specular{"specular", true, "textures that tint highlights"};
    Knob<bool> emissive{"emissive", true, "textures that glow"};
    Knob<bool> opacity{"opacity", true, "textures of holes"};
    Knob<bool> normal{"normal", true, "normal maps"};
    Knob<bool> height{"height", true, "height maps"};
    Knob<bool> orm{"orm", true, "textures of occlusion, roughness and metalness"};
    Knob<bool> occlusion{"occlusion", true, "textures of ambient occlusion alone"};
    Knob<bool> gloss{"gloss", true, "textures of the exponent, 8 to 256"};
    Knob<bool> detail_normal{"detail_normal", true, "fine normal maps on top of the others"};

    /// Sets the switches' macros for a pipeline that draws `item`.
    void define(Defines& defines, const DrawItem& item) const;
};

/// Makes the levels anew of what must not be averaged as colours are: normal maps (see normal_levels) and alpha (see
/// cutout_levels; `cutoff` below 0: averaged). Of height maps only the first level is read, with 16 bits.
void make_mips(Gpu& gpu, Scene& scene, float cutoff);

/// The first level of an image as numbers; sRGB becomes linear. Waits for the device.
Level read_level(Gpu& gpu, const Image& image);

/// The mean of a picture of hit errors or of swimming over the pixels where there is one, in texels of the height map.
double mean_texels(const ImageRgb& picture);

/// Draws the batch with each triangle cut into subdivide × subdivide.
void draw_displaced(Raster& pass, const Batch& batch, uint32_t subdivide);

}  // namespace lightwalk
