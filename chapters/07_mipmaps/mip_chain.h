// Module that builds the smaller levels of an image on the GPU; later chapters use it for any image with levels.
#pragma once
#include "common/app/module.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// A level as shaders read and write it: all layers, no encoding.
inline ImageView plain_level(const ImageView& image, uint32_t level) { return image.mip(level).as_array().codes(); }

class Coverage {
  public:
    /// Multiplies the alpha of the view's levels from its second on, which are the means by now. Waits for nothing on
    /// the host.
    void record(Frame& frame, const ImageView& image, float cutoff);

  private:
    static Pipeline step(const char* number) {
        return compute({.shader = "07_mipmaps/coverage.comp", .macros = {{"STEP", number}}});
    }
    Pipeline clear_ = compute({.shader = "07_mipmaps/clear_words.comp"});
    Pipeline count_ = step("0"), find_ = step("1"), scale_ = step("2");
    Buffer counts_, factors_;
};

/// Meaning of the numbers in an image, which decides how they are averaged.
enum class Content {
    each,       ///< not stated: srgb or linear, according to the format of the image
    linear,     ///< numbers as they are: light, heights, moments
    srgb,       ///< sRGB codes: light; alpha as it is
    normal,     ///< normal map: vectors, alpha = √(1 - length of their mean), 0 in the first level
    cutout,     ///< sRGB codes weighted by alpha; with alpha as much of a level is cut out as of the first
    roughness,  ///< occlusion, roughness, metalness: of roughness the fourth power
};

/// Fills the levels of an image from its first: in a frame, where the first has been written,
///
///     chain.record(frame, bloom.all_mips());
///
/// and later passes may read them all. RGBA8 (sRGB or not), RGBA16F, RG16, RG16F, R32F and any other format that the
/// device writes from shaders; 2-D images, arrays, cubes, single faces; any size. A module may record many images in
/// one frame.
struct MipChain : Module {
    MipChain(Module& owner, std::string name);

    Choice method{
        *this,
        "method",
        {"none", "blit", "box", "single_pass", "polyphase", "kaiser"},
        "single_pass",
        "Construction of the levels: not at all; the driver's blits; 2x2 means with one dispatch per level; 2x2 means "
        "in a single dispatch; weights that are exact for odd sizes; a wider filter (Kaiser window)"};
    Choice content{
        *this,
        "content",
        {"each", "linear", "srgb", "normal", "cutout", "roughness"},
        "each",
        "Quantity averaged: chosen for each image by its use, or for all images the numbers as stored, light decoded "
        "from sRGB, vectors of a normal map, colours weighted by alpha, the fourth power of roughness"};

    Knob<bool> bilinear{*this, "bilinear", false, "Mean of four texels by one linear lookup (method single_pass)"};
    Choice reduction{*this,
                     "reduction",
                     {"auto", "shared", "shuffle"},
                     "auto",
                     "Exchange of means within a workgroup (method single_pass): through shared memory, by subgroup "
                     "shuffles, or by shuffles where subgroups have 32 threads or more (auto)"};

    /// Records the view's levels from the second on. The view has all mips to fill. With method `none`, or one level,
    /// nothing is recorded. `cutoff`: alpha threshold of a cut-out. Throws Failure if the device cannot write the
    /// format.
    void record(Frame& frame, const ImageView& image, Content what = Content::each, float cutoff = 0.5f);

    /// Averages of record() for an image with this content.
    Content content_of(const ImageView& image, Content what) const;

  private:
    void record_blits(Frame& frame, const ImageView& image);
    void record_levels(Frame& frame, const ImageView& image, const Macros& variant);
    void record_single_pass(Frame& frame, const ImageView& image, Macros variant);
    Pipeline box_ = compute({.shader = "07_mipmaps/box.comp"});
    Pipeline polyphase_ = compute({.shader = "07_mipmaps/polyphase.comp"});
    Pipeline kaiser_ = compute({.shader = "07_mipmaps/kaiser.comp"});
    Pipeline single_pass_ = compute({.shader = "07_mipmaps/single_pass.comp"});
    Pipeline clear_ = compute({.shader = "07_mipmaps/clear_words.comp"});
    Buffer tiles_, finished_;    ///< of the single pass
    uint32_t next_counter_ = 0;  ///< of finished_ that no dispatch has used since all were cleared
    uint32_t lanes_ = 0;         ///< Limits::shuffling_lanes, once asked
    Coverage coverage_;
};

}  // namespace lightwalk
