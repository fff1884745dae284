// Culling module: objects that no pixel of a view can show are not drawn.
#pragma once
#include <array>
#include <map>

#include "06_deferred/culling_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Texels of mip m hold the farthest (smallest) depth of 2^(m+1) pixels in each direction; the last ones also cover odd
/// remainders. Five levels take one dispatch.
class DepthPyramid {
  public:
    explicit DepthPyramid(std::string name) : name_(std::move(name)) {}

    /// `depth`: reversed, any size. The result is valid in later frames.
    void record(Frame& frame, const ImageView& depth);

    const Image& image() const { return image_; }  ///< R32F; its first mip has half of the depth's size
    /// Size of the depth image in pixels; 0 before the first record().
    glm::uvec2 pixels() const { return pixels_; }
    int levels() const { return image_ ? static_cast<int>(image_.desc.mips) : 0; }

  private:
    std::string name_;
    Image image_;
    glm::uvec2 pixels_{0};
    Pipeline five_levels_ = compute({.shader = "06_deferred/depth_pyramid.comp"});
};

/// The six planes of a view's volume: xyz of unit length points inwards, and dot(xyz, p) + w >= 0 for a point p inside.
/// They are moved outwards by `margin_m`. A far plane at infinity holds for every point. (G. Gribb and K. Hartmann,
/// 2001.)
std::array<glm::vec4, 6> view_planes(const glm::mat4& view_projection, float margin_m);

/// Per view: begin(), then passes() for each pass over its objects, which has the module in `.with` and draws batches
/// by draw(). Culling changes no picture.
struct Culling : Module {
    Culling(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "frustum_cpu", "frustum_gpu", "occlusion"},
                  "none",
                  "Objects left out: none; those outside of the view, found by the processor (frustum_cpu) or by a "
                  "dispatch (frustum_gpu); or those hidden behind others, too (occlusion)"};
    Choice bounds{*this,
                  "bounds",
                  {"box", "sphere"},
                  "box",
                  "Bounds of objects that are tested against the view: a box, or the sphere around it"};
    Knob<int> least{*this, "least", 0, {0, 1000000}, "Number of objects from which on they are left out"};

    /// `batches`: everything the view draws; empty: no culling.
    void begin(Frame& frame, const Scene& scene, const View& view, const std::vector<Batch>& batches);

    /// Records a pass; the view's first pass twice if hidden objects are culled. The second recording draws newly
    /// visible objects into the same targets. `depth`: depth target; occlusion culling needs one sample a pixel.
    void passes(Frame& frame, const ImageView& depth, const std::function<void()>& record);

    /// Draws the listed objects of a batch with the current pipeline.
    void draw(Raster& pass, const Batch& batch) const;

    bool culls() const { return !groups_.empty(); }
    /// Whether the second of two recordings is running.
    bool completes() const { return first_list_ == 1; }

    std::vector<Resource> reads() const override;
    std::vector<std::string> status() const override;
    /// Number of objects drawn in the last view; for GPU culling, of the last finished frame.
    size_t drawn() const;
    size_t tested() const { return objects_.size(); }
    /// CPU time of the last view's lists, milliseconds.
    double host_ms() const { return host_ms_; }

  private:
    /// Result of a dispatch: ranks, compacted instances, a draw command per group.
    struct List {
        Buffer ranks, sums, total, instances, draws;
        ReadBack count;
    };
    struct Seen {  ///< state of a view's last frame
        explicit Seen(std::string name) : pyramid(std::move(name)) {}
        DepthPyramid pyramid;  ///< empty before the first frame
        glm::mat4 to_clip{1.0f};
    };
    void group(Frame& frame, const std::vector<Batch>& batches);
    void find();
    void list(Frame& frame, const Pipeline& which, size_t into);
    Seen& view_seen();

    const Scene* scene_ = nullptr;
    uint32_t view_id_ = 0;
    glm::mat4 to_clip_{1.0f};
    std::array<glm::vec4, 6> planes_{};
    std::vector<CulledObject> objects_;
    std::vector<DrawGroup> groups_;
    std::vector<std::vector<Batch>> found_;  ///< CPU lists by group
    Fingerprint grouped_;
    Buffer object_data_, group_data_;
    List lists_[2];                           ///< objects of the first recording, and of the second
    size_t first_list_ = 0, list_count_ = 0;  ///< range of lists to draw
    double host_ms_ = 0;
    bool listed_ = false;            ///< first pass of the view is done
    std::map<uint32_t, Seen> seen_;  ///< by View::id
    Pipeline all_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "SEEN"}}});
    Pipeline seen_before_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "SEEN_BEFORE"}}});
    Pipeline appearing_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "APPEARED"}}});
    Pipeline sum_ = compute({.shader = "06_deferred/sum_lists.comp"});
    Pipeline write_ = compute({.shader = "06_deferred/write_draws.comp"});
};

}  // namespace lightwalk
