// The chapter's picture in a window: drawn, refined at rest, shown alone or beside the reference's.
#pragma once
#include <functional>
#include <optional>

#include "common/app/chapter.h"
#include "common/gpu/capture.h"
#include "common/scene/view.h"
#include "common/window/frame_graph.h"
#include "common/window/split_view.h"

namespace lightwalk {

class PixelProbe {
  public:
    /// Of the frame that was drawn last; reads back anew where the pixel or the frame is another. None: no words.
    void look(Gpu& gpu, const Frame& frame, const Chapter& chapter, std::optional<glm::uvec2> at);

    /// "412, 233", the value, the depth, the object and its material, as far as they are known.
    const std::vector<std::string>& words() const { return words_; }

  private:
    std::vector<std::string> words_;
    std::optional<glm::uvec2> at_;
    uint64_t frame_ = 0;
    double next_s_ = 0;
};

class WindowPicture {
  public:
    static constexpr int most_samples = 16;  ///< of a picture at rest

    /// `scene` is loaded by the chapter already; the reference loads it when the view is split.
    WindowPicture(LiveChapter& live, Gpu& gpu, const MakeChapter& make, std::filesystem::path scene, unsigned seed)
        : split(gpu, make, std::move(scene)),
          live_(live),
          gpu_(gpu),
          seed_(seed),
          frame_(gpu, {.listener = &graph.flow}) {}

    Look look;
    SplitView split;
    FrameGraph graph;
    int refined = 0;  ///< samples that the picture has gathered at rest

    /// The chapter, and the reference where the view is split. With `captured`, RenderDoc captures the chapter's frame.
    void draw(glm::uvec2 size, float time_s, const std::function<void(Capture&)>& captured);
    bool can_refine() const;    ///< samples are missing, and more of them make a better picture
    void refine(float time_s);  ///< by a sample at another place within each pixel
    bool has(glm::uvec2 size) const { return shown_ && size_ == size; }

    /// Records in `screen` what joins both sides, where there are two. The picture stays until the next draw().
    const Image& show(Frame& screen);
    const Image* shown() const { return shown_; }  ///< null: none yet
    const Frame& frame() const { return frame_; }  ///< the chapter's
    void set_frames_in_flight(size_t in_flight) { frame_.set_frames_in_flight(in_flight); }

    /// Compares both sides once they are `still`; while they move, each second. Returns whether a figure has come.
    bool compare(bool still, bool moves);

  private:
    const Image& mine() const { return look.picture(frame_, viewed_); }
    LiveChapter& live_;
    Gpu& gpu_;
    const unsigned seed_;
    Image viewed_, composed_;  ///< the part of the frame that is looked at; both sides of a split view
    Frame frame_;
    glm::uvec2 size_{0};
    const Image* shown_ = nullptr;
    bool compared_ = false;
    double next_compare_s_ = 0;
};

}  // namespace lightwalk
