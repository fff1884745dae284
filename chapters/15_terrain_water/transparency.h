// Transparency module: seven ways to mix transparent surfaces, and depth peeling as the reference.
#pragma once
#include <map>
#include <set>

#include "15_terrain_water/transparency_data.h"
#include "common/app/drawing.h"

namespace lightwalk {

/// In a frame, before anything is drawn:
///
///     canvas.blended_by(&transparency);
///
/// Then draw() blends transparent surfaces in that canvas by the chosen method.
struct Transparency : Module, TransparencyMethod {
    Transparency(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"unsorted", "sorted", "sorted_triangles", "wboit", "moments", "moments6", "lists", "peeling"},
                  "sorted",
                  "Transparent surfaces: in the order of the scene; sorted by object; sorted by triangle; a weighted "
                  "sum (WBOIT); a transmittance from four moments or from six (MBOIT); all fragments of a pixel in "
                  "a list; or depth peeling, the reference"};
    Choice weight{*this,
                  "weight",
                  {"mean", "eq7", "eq8", "eq9", "eq10"},
                  "eq7",
                  "Weight of a fragment (method wboit): the same for all, or equation 7, 8, 9 or 10 of McGuire and "
                  "Bavoil"};
    Choice sums{*this,
                "sums",
                {"fp16", "fp32"},
                "fp16",
                "Precision of the weighted sums: half floats, which end at 65504, or floats"};
    Choice revealage{*this,
                     "revealage",
                     {"r8", "r16f"},
                     "r16f",
                     "Precision of the background's share (method wboit): 8 bits, or half floats"};
    Choice tint{
        *this,
        "tint",
        {"grey", "rgb"},
        "rgb",
        "Light that passes through coloured glass: the same share of each colour, their mean (grey), or a share "
        "of each (rgb)"};
    Knob<float> moment_bias{*this,
                            "moment_bias",
                            5e-7f,
                            {0.0f, 0.01f},
                            "Share of four moments replaced by those of a wide distribution, against rounding; of six "
                            "ten times as much"};
    Knob<float> overestimation{
        *this, "overestimation", 0.25f, {0.0f, 1.0f}, "Share of a fragment's own absorbance that lies before it"};
    Knob<int> list_fragments{
        *this, "list_fragments", 8, {1, 64}, "Initial room for fragments in the lists: mean number per pixel"};
    Knob<int> peels{*this, "peels", 16, {1, 128}, "Number of layers that are peeled off, nearest first"};

    void record(Frame& frame, const View& view, Canvas& canvas,
                const std::vector<TransparentSurface>& surfaces) override;
    std::vector<std::string> status() const override;

  private:
    struct Targets {  ///< of a view
        Image sum, share, moments, absorbance, tints, layer, layer_tint, layer_depth[2], peeled, passed;
        Buffer heads, fragments, count;
        ReadBack counted;
        uint32_t room = 0;  ///< fragments
        Buffer indices;
    };
    class Stage;
    void draw_stage(Frame& frame, const char* pass, RasterTargets targets, const Stage& stage,
                    const std::vector<TransparentSurface>& surfaces);
    void draw_triangles(Frame& frame, const View& view, Canvas& canvas, const std::vector<TransparentSurface>& surfaces,
                        Targets& t);
    void add_weighted(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces, Targets& t);
    void add_by_moments(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces, Targets& t);
    void mix_lists(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces, Targets& t);
    void peel(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces, Targets& t);
    VkFormat sum_format() const {
        return sums.is("fp16") ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
    }

    std::map<uint32_t, Targets> targets_;
    TransparencyNow now_{};
    uint32_t listed_ = 0;  ///< fragments of the last lists
    Pipeline mix_weighted_ = compute({.shader = "15_terrain_water/mix_weighted.comp"});
    Pipeline mix_moments_ = compute({.shader = "15_terrain_water/mix_moments.comp"});
    Pipeline clear_lists_ = compute({.shader = "15_terrain_water/clear_lists.comp"});
    Pipeline mix_lists_ = compute({.shader = "15_terrain_water/mix_lists.comp"});
    Pipeline add_layer_ = compute({.shader = "15_terrain_water/add_layer.comp"});
    Pipeline mix_peeled_ = compute({.shader = "15_terrain_water/mix_peeled.comp"});
};

}  // namespace lightwalk
