// Picking module: which of the scene's items is seen in a pixel, by three methods on the device.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/rays.h"
#include "18_playground/exercises.h"
#include "common/app/target.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Finds the items under all pixels of a view, or under one: record(), then pick(), and a frame later picked().
struct Picker : Module {
    Picker(Module& owner, std::string name);

    Choice method{
        *this,
        "method",
        {"boxes", "rays", "rays_cut", "ids"},
        "ids",
        "Picking: the nearest bounding box (boxes); the nearest triangle along a ray (rays), with holes cut by "
        "textures (rays_cut); or an image of item numbers that the scene is drawn into (ids)"};
    Knob<int> reach{*this, "reach", 4, {0, 16}, "Distance within which a click beside a thin thing picks it", "px"};
    SceneRays rays{*this, "rays"};

    /// Numbers of items, by the exercise 18.id_buffer's code; 0: nothing.
    Target ids{*this, {.name = "ids", .format = VK_FORMAT_R32_UINT}};

    /// Fills `ids` for the view at the frame's size.
    void record(Frame& frame, const View& view, const Scene& scene, const Maps& maps);

    /// Requests the item at or near this pixel; the recording frame answers after it has ended.
    void pick(Frame& frame, glm::ivec2 pixel);
    /// Result of the last completed pick(). True once for each.
    bool poll();
    std::optional<uint32_t> item;  ///< of Scene::items; none: nothing is there

  private:
    void draw_ids(Frame& frame, const Scene& scene, const Maps& maps);
    void trace(Frame& frame, const View& view, const Scene& scene, const Maps& maps);
    Target depth_{*this, {.name = "ids depth", .format = VK_FORMAT_D32_SFLOAT}};
    SurfacePipelines id_{{.fragment = "18_playground/id.frag"}};
    SurfacePipelines glass_{{.fragment = "18_playground/id.frag", .macros = {{"TRANSPARENT", "1"}}}};
    Pipeline trace_ = compute({.shader = "18_playground/trace.comp"});
    Pipeline boxes_ = compute({.shader = "18_playground/boxes.comp"});
    Pipeline near_ = compute({.shader = "18_playground/near.comp"});
    Buffer item_boxes_, triangle_items_, result_;
    uint64_t placed_ = 0;
    ReadBack read_;
    bool asked_ = false;
};

}  // namespace lightwalk
