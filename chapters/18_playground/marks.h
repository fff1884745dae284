// The editor's marks over the finished picture: outlines of the selection, the gizmo, lights and their cones.
#pragma once
#include "18_playground/gizmo.h"
#include "18_playground/mark_data.h"
#include "18_playground/picker.h"

namespace lightwalk {

/// A line over the picture, with its ends in the world; its width in pixels.
using MarkLine = MarkSegment;

struct Marks : Module {
    Marks(Module& owner, std::string name) : Module(owner, std::move(name), "marks") {}

    Knob<bool> on{*this, "on", true, "Outline of the selection, gizmo, and symbols of the lights"};
    Knob<float> width{*this, "width", 2.0f, {1.0f, 8.0f}, "Width of outlines", "px"};

    /// `picture` is finished and linear, 0 to 1. `selected`: of each of the scene's items, as picker.ids has them; 0
    /// if it is not, and one number for all items of an entry, so that each entry has an outline of its own.
    void record(Frame& frame, const View& view, const Image& picture, const Picker& picker,
                const std::vector<uint32_t>& selected, const std::vector<MarkLine>& lines, float scale = 1.0f);

  private:
    Pipeline outline_ = compute({.shader = "18_playground/outline.comp"});
    Pipeline line_ = graphics({.vertex = "18_playground/line.vert",
                               .fragment = "18_playground/line.frag",
                               .cull = VK_CULL_MODE_NONE,
                               .depth_test = false,
                               .depth_write = false,
                               .blend = Blend::alpha});
    Buffer lines_, selected_;
};

/// The gizmo's lines; `hot` is drawn brighter.
void add_gizmo(std::vector<MarkLine>& lines, const GizmoPlace& place, const View& view, const Handle& hot);
/// A symbol of constant size for each light, and the cone or range of selected ones; above a hundred only the active
/// one's.
void add_lights(std::vector<MarkLine>& lines, const Document& document, const Selection& selection, const View& view,
                float scale = 1.0f);

}  // namespace lightwalk
