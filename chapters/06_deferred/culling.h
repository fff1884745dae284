// Culling module: objects that no pixel of a view can show are not drawn.
#pragma once
#include <array>
#include <map>

#include "06_deferred/culling_data.h"
#include "06_deferred/depth_pyramid.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

/// The six planes of a view's volume: xyz of unit length points inwards, and dot(xyz, p) + w >= 0 for a point p inside.
/// They are moved outwards by `margin_m`. A far plane at infinity holds for every point. (G. Gribb and K. Hartmann, 2001.)
std::array<glm::vec4, 6> view_planes(const glm::mat4& view_projection, float margin_m);

// [culling]
/// For a view: begin(), then passes() for each pass over its objects, which states the module in `.with` and draws
/// batches by draw(). Culling changes no picture.
struct Culling : Module {
    Culling(Module& owner, std::string name) : Module(owner, std::move(name), "culling") {}

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

    /// `batches`: all that the view draws; none: nothing is culled.
    void begin(Frame& frame, const Scene& scene, const View& view, const std::vector<Batch>& batches);

    /// Records a pass. The view's first one is recorded twice if hidden objects are culled; the second time it draws
    /// the newly visible objects over the same targets. `depth`: its target; hidden objects are culled only with one
    /// sample a pixel.
    void passes(Frame& frame, const ImageView& depth, const std::function<void()>& record);

    /// The listed objects of a batch. A pipeline is in use.
    void draw(Raster& pass, const Batch& batch) const;

    bool culls() const { return !groups_.empty(); }
    /// In the second of two passes.
    bool completes() const { return first_list_ == 1; }

    std::vector<Resource> reads() const override;
    std::vector<std::string> status() const override;
    /// Objects that the last view drew; of dispatches, in the last frame that ended.
    size_t drawn() const;
    size_t tested() const { return objects_.size(); }
    /// Milliseconds that the processor took for the last view's lists.
    double host_ms() const { return host_ms_; }
    // [/culling]

  private:
    /// Result of a dispatch: the rank of each object, listed instances side by side, a draw command for each group.
    struct List {
        Buffer ranks, sums, total, instances, draws;
        ReadBack count;
    };
    struct Seen {  ///< in a view's last frame
        explicit Seen(std::string name) : pyramid(std::move(name)) {}
        DepthPyramid pyramid;  ///< no levels: it has seen nothing yet
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
    std::vector<std::vector<Batch>> found_;  ///< by the processor, of each group
    Fingerprint grouped_;
    Buffer object_data_, group_data_;
    List lists_[2];                           ///< a view's first pass, and the objects that appear in the second
    size_t first_list_ = 0, list_count_ = 0;  ///< to draw now
    double host_ms_ = 0;
    bool listed_ = false;            ///< the view has had its first pass
    std::map<uint32_t, Seen> seen_;  ///< by View::id
    Pipeline all_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "SEEN"}}});
    Pipeline seen_before_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "SEEN_BEFORE"}}});
    Pipeline appearing_ = compute({.shader = "06_deferred/list_objects.comp", .macros = {{"LISTS", "APPEARED"}}});
    Pipeline sum_ = compute({.shader = "06_deferred/sum_lists.comp"});
    Pipeline write_ = compute({.shader = "06_deferred/write_draws.comp"});
};

}  // namespace lightwalk
