// The student's version and the reference side by side, and how much they differ.
#pragma once
#include <future>

#include "common/app/look.h"
#include "common/image/image.h"
#include "common/window/live_chapter.h"

namespace lightwalk {

/// Mean FLIP of two pictures. Computed on another thread at `1 / shrink` of their size.
struct PictureDifference {
    double flip_mean = 0;
    int shrink = 1;
};

class SplitView {
  public:
    /// `make` makes the second chapter; it lives while the split view is on.
    SplitView(Gpu& gpu, const MakeChapter& make, std::filesystem::path scene);

    float divider = 0.5f;  ///< share of the picture's width that the left side has
    bool on() const { return live_ != nullptr; }
    bool drawn() const { return on() && frame_->output; }  ///< there is a picture of the reference

    /// Throws InputError if even the reference cannot load the scene.
    void turn_on(const Chapter& chapter);
    void turn_off();

    /// Forgets the scene; the next frame reloads it.
    void reload();

    /// Draws the reference with the camera and the knobs of `chapter`.
    void draw(const Chapter& chapter, const Look& look, const Picture& picture);
    /// The reference's picture as chosen by `look`.
    const Image& picture(const Look& look) const { return look.picture(*frame_, viewed_); }
    std::string error() const;

    /// Starts the comparison unless one is running or the two are those compared last; poll() has the result when it is
    /// done.
    void compare(const Image& mine, const Image& reference);
    bool poll();  ///< true when a result has just come
    std::optional<PictureDifference> difference;

  private:
    Gpu& gpu_;
    MakeChapter make_;
    std::filesystem::path scene_;
    std::unique_ptr<Chapter> chapter_;
    std::unique_ptr<LiveChapter> live_;
    Image viewed_;  ///< of `look`
    std::unique_ptr<Frame> frame_;
    std::future<PictureDifference> running_;
    uint64_t compared_ = 0;  ///< hash of the two pictures
};

}  // namespace lightwalk
