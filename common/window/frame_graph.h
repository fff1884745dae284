// The frame as a graph below the picture: passes in order, an image of each target, and who reads it.
#pragma once
#include "common/app/look.h"
#include "common/window/blit.h"
#include "common/window/frame_flow.h"

namespace lightwalk {

class FrameGraph {
  public:
    static constexpr uint32_t height = 226;  ///< pixels at scale 1

    FrameFlow flow;  ///< listens to the frame
    bool shown() const { return flow.on; }
    void show(bool on) { flow.on = on; }

    /// Of the window, in pixels; 0 while it is hidden, and in a window that it would fill.
    uint32_t height_px(float scale, uint32_t window_height) const;

    /// Makes the frame draw an image of each target when its pass was recorded, after Look::attach().
    void attach(Frame& frame, const Camera& camera, const Bounds& bounds);

    /// A click shows an image large, by `look`, or the picture again. True if it was clicked.
    bool draw(const Area& room, float scale, const Frame& frame, Look& look);

    /// Copies the images to where draw() left room for them. For a transfer pass that reads images().
    const Image& images() const { return images_; }
    bool has_images() const { return !copies_.empty() && images_; }
    void blit_to(VkCommandBuffer commands, const Image& window) const;

  private:
    struct Place;
    bool draw_node(const FrameFlow::Node& node, const Place& place, const Frame& frame, Look& look);
    void draw_edges(const std::vector<Place>& places, float bottom, const Frame& frame);
    float image_x(const FrameFlow::Edge& edge, const Frame& frame) const;
    void explain(const FrameFlow::Node& node, size_t index) const;
    void place_images(const std::vector<Place>& places, const Area& room, glm::vec2 rows_px, const Frame& frame);
    void choose_width(glm::vec2 room, float scale);
    void fill_between(const Area& room, float top, float bottom) const;
    Image images_;                               ///< small ones in rows, by number of output
    std::vector<std::pair<Area, Area>> copies_;  ///< from images_ to the window
    std::vector<FrameFlow::Node> nodes_;
    std::vector<FrameFlow::Edge> edges_;  ///< short ones first
    float image_px_ = 0.0f;               ///< width of an image
    size_t hovered_ = SIZE_MAX;           ///< node
    std::string logged_;
};

}  // namespace lightwalk
