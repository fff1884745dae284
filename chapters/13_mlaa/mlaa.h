// Anti-aliasing module, for any picture in linear light.
#pragma once
#include <optional>
#include <utility>

#include "13_mlaa/moving.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/scene/view.h"

namespace lightwalk {

/// The scene behind a picture, for methods that follow surfaces from frame to frame.
struct Seen {
    const View& view;              ///< that it was drawn from
    const ImageView& depth;        ///< D32F, reversed: 0 where nothing is
    const Scene* scene = nullptr;  ///< its items may move; null: nothing does
    /// Of the picture; those that are a MovingSurface may move as well. None: whether the picture rests is not known.
    Drawings drawings{};
};

/// Mixes each frame with the history of the pixel: earlier samples of the same surface. The renderer shifts each
/// frame within a pixel (Module::accumulation); a written picture takes `warm_up` of them from a cold start, so that it
/// depends on its time alone.
struct Taa : Module {
    Taa(Module& owner, std::string name);

    Knob<int> warm_up{*this, "warm_up", 32, {1, 256}, "Frames drawn from a cold start for a picture that is written"};
    Knob<float> at_rest{
        *this,
        "at_rest",
        32.0f,
        {1.0f, 256.0f},
        "Samples that the history of a pixel at rest is worth at most, while something in the picture moves"};
    Knob<float> in_motion{
        *this, "in_motion", 6.0f, {1.0f, 256.0f}, "Samples that it is worth where it moves by a pixel or more a frame"};
    Choice clipping{
        *this,
        "clipping",
        {"none", "box", "deviation"},
        "deviation",
        "Limits of the history: none; the range of the 3×3 pixels around it in the new frame (box); or within "
        "that range their mean and a multiple of their standard deviation"};
    Knob<float> gamma{*this, "gamma", 1.0f, {0.0f, 8.0f}, "Standard deviations that the history may be off"};
    Knob<bool> reject{*this, "reject", true, "Rejection of the history where something nearer was seen before"};
    Choice resample{*this,
                    "resample",
                    {"bilinear", "catmull_rom"},
                    "catmull_rom",
                    "Filter that reads the history between its pixels: bilinear, or Catmull-Rom in five reads"};
    Choice weights{*this,
                   "weights",
                   {"even", "tone"},
                   "even",
                   "Weights of new light and history: their shares alone, or divided by 1 + luminance (tone), which "
                   "calms bright pixels and darkens edges"};
    Knob<bool> motion{*this, "motion", true, "Motion of objects and water; without it only that of the camera"};

    /// `picture`: RGBA16F, drawn from the view with its shift; gets the picture without it. Once per frame and module.
    void record(Frame& frame, const Image& picture, const Seen& seen);
    Accumulation accumulation() const override;
    bool animated() const override { return true; }

  private:
    /// Whether the frame before left a history. Images are made by the first frame that needs them.
    class Remembered : public TargetBase {
      public:
        using TargetBase::TargetBase;
        void begin_frame(Gpu&, glm::uvec2) override { valid = std::exchange(written, false); }
        void forget() override { valid = written = false; }
        bool valid = false, written = false;
    };
    bool set_up(Frame& frame, glm::uvec2 size, const Seen& seen);
    bool is_unchanged(const Frame& frame, const Seen& seen);

    Remembered remembered_{*this};
    Image
        light_[2];  ///< RGBA16F: the history and its samples, below 0 where it moves; of this frame, of the one before
    Image behind_[2];  ///< R32F: 1/m, of the farthest of 3×3 pixels
    Moving moving_;
    std::optional<View> before_;
    Fingerprint unchanged_;
    LightList lights_;
    const Scene* scene_ = nullptr;
    std::filesystem::path scene_file_;  ///< another scene may be loaded at the same address
    Pipeline still_ = compute({.shader = "13_mlaa/taa.comp", .macros = {{"MOVING", "0"}}});
    Pipeline follow_ = compute({.shader = "13_mlaa/taa.comp", .macros = {{"MOVING", "1"}}});
    Pipeline show_ = compute({.shader = "13_mlaa/taa_show.comp"});
};

/// In a frame, where the picture is drawn and light above what a screen shows is cut off:
///
///     antialias.record(frame, frame.hdr, {view, frame.depth, &scene});
///
/// mixes pixels of the RGBA16F image, of any size up to 65535 a side, with their neighbours along its edges, in linear
/// light. What lies beside no edge stays as it is, to the bit; a pixel that is mixed has no NaN, and alpha stays. After
/// fxaa_like the image has another handle, since it was written anew. The method taa changes every pixel, by what it saw
/// in the frames before (taa.h). The methods from msaa_4x on are about how a picture is drawn: record() then does nothing
/// (see drawing.h). Once per frame and module.
struct Mlaa : Module {
    Mlaa(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "fxaa_like", "mlaa", "smaa_like", "taa", "msaa_4x", "supersample_4"},
                  "mlaa",
                  "Anti-aliasing: none; FXAA-like; morphological (MLAA); SMAA-like; temporal, over frames (taa); "
                  "multisampling with four samples; four pictures"};
    Knob<int> reach{
        *this, "reach", 255, {2, 255}, "Reach: distance to which a line of edges is followed to each side of a pixel",
        "px"};
    Choice reads{
        *this,
        "reads",
        {"two", "four", "words"},
        "words",
        "Reads that give a distance: two or four numbers in each of several passes, so that distances double or "
        "quadruple; or words of sixteen edges, in one pass"};
    Knob<float> threshold{
        *this, "threshold", 12.0f, {0.0f, 100.0f}, "Threshold of an edge: difference of two neighbours in CIELAB"};
    Knob<int> search{*this, "search", 16, {1, 255}, "Search distance for the ends of an edge (method fxaa_like)", "px"};

    Knob<bool> count{*this, "count", false,
                     "Counting of the pixels beside edges and of the mixed pixels, read back to the CPU"};

    Taa taa{*this, "taa"};

    void record(Frame& frame, Image& picture, const Seen& seen);
    /// Throws Failure for taa, which needs to know what is seen.
    void record(Frame& frame, Image& picture);

    /// Whether it needs the picture alone, drawn once.
    bool is_filter() const { return method.is("fxaa_like") || follows_edges(); }
    bool follows_edges() const { return method.is("mlaa") || method.is("smaa_like"); }
    bool doubles() const { return !reads.is("words"); }

    /// Passes over the list until lines are followed as far as `reach`, after the one that links neighbours. None with
    /// words.
    int passes() const;

    /// Of the last frame recorded, for viewing: words of edges (13_mlaa/edge_words.glsl), and, if distances double, beside
    /// edges four bytes (13_mlaa/distance_bits.glsl). All r32ui.
    const Image& edge_rows() const { return edge_rows_; }
    const Image& edge_columns() const { return edge_columns_; }
    const Image& distances() const { return *lengths_; }
    void set_edges(Compute& pass) const;  ///< Binds the first two.

    /// Draws the edges of that frame over the picture in grey, or the lengths of their lines; nothing where the method
    /// follows none.
    void show_edges(Frame& frame, const Image& picture, bool lengths) const;

    /// How many pixels were looked at as lying beside an edge, and how many of them were mixed, in the frame that ended
    /// last of those recorded with `count` on.
    struct Counts {
        uint32_t listed = 0, changed = 0;
    };
    Counts counts() const;
    std::vector<std::string> status() const override;

  private:
    void set_up(Frame& frame, const Image& picture);
    void follow_edges(Frame& frame, const Image& picture);
    void search_by_luma(Frame& frame, Image& picture);
    void measure_by_doubling(Compute& pass);
    const Image* propagate(Compute& pass, const Image* from, const Image* into,
                           const glm::ivec2 (&directions)[4]) const;
    Compute& over_list(Compute& pass, const Pipeline& pipeline) const;

    Image edge_rows_, edge_columns_;
    Image distances_[2], diagonals_[2];                       ///< for passes that double
    const Image *lengths_ = nullptr, *staircases_ = nullptr;  ///< of those, as the last frame left them
    Image areas_, crossings_;
    Fingerprint tables_made_;
    Image light_;              ///< of listed pixels, before it is mixed; with fxaa_like the picture of the frame before
    Buffer work_, next_work_;  ///< of this frame, and, which this frame empties, of the next
    Buffer list_;
    ReadBack counted_;
    Pipeline edges_ = compute({.shader = "13_mlaa/edges.comp", .macros = {{"DROPS_HIDDEN", "0"}}});
    Pipeline seen_edges_ = compute({.shader = "13_mlaa/edges.comp", .macros = {{"DROPS_HIDDEN", "1"}}});
    Pipeline diagonal_seeds_ = compute({.shader = "13_mlaa/diagonal_seeds.comp"});
    Pipeline links_ = compute({.shader = "13_mlaa/links.comp"});
    Pipeline propagate_ = compute({.shader = "13_mlaa/propagate.comp"});
    Pipeline mix_ = compute({.shader = "13_mlaa/mix.comp"});
    Pipeline mix_shapes_ = compute({.shader = "13_mlaa/mix_shapes.comp"});
    Pipeline fxaa_ = compute({.shader = "13_mlaa/fxaa.comp"});
    Pipeline edges_in_color_ = compute({.shader = "13_mlaa/edges_in_color.comp", .macros = {{"LENGTHS", "0"}}});
    Pipeline lengths_in_color_ = compute({.shader = "13_mlaa/edges_in_color.comp", .macros = {{"LENGTHS", "1"}}});
};

}  // namespace lightwalk
