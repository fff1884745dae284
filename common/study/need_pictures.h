// Pictures of the need rule: the truth and the candidates, in small, in crops and whole.
#pragma once
#include "common/app/render.h"
#include "common/study/crops.h"
#include "common/study/need.h"
#include "common/study/study_plan.h"

namespace lightwalk {

/// Milliseconds that a crop and the whole picture take.
struct DrawTimes {
    double crop_ms, whole_ms;
};

/// Whether `crops` crops of the truth and of `count` candidates take less than half the time of their whole pictures.
inline bool crops_are_cheaper(size_t crops, DrawTimes truth, DrawTimes candidate, size_t count) {
    const double others = static_cast<double>(count);
    return static_cast<double>(crops) * (truth.crop_ms + others * candidate.crop_ms) <
           0.5 * (truth.whole_ms + others * candidate.whole_ms);
}

/// Draws each thing once, however often it is asked for, apart from times. Afterwards all knobs are put back.
class NeedPictures {
  public:
    /// Takes the plan's candidates that agree with the chapter's pinned knobs and their own `where`. Throws
    /// InputError if none does.
    NeedPictures(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const Picture& picture, FrameClock clock);
    ~NeedPictures();

    struct Measured {
        double error = 0;  ///< mean FLIP against the truth
        double ms = 0;     ///< the clock's time of the candidate
    };

    std::function<void()> between;  ///< before each picture, where there is one
    std::vector<StudyPoint> candidates;
    const std::vector<CropPlace> places;      ///< empty if the picture is not large
    double truth_crops_ms = 0, truth_ms = 0;  ///< GPU time of the truth's crops so far, and of its whole picture

    /// Large enough for crops: so many of them are at most half of it.
    static bool large(glm::uvec2 whole);

    /// A picture of a quarter of the sides, as large to the eye; `by_place` becomes its error at each place.
    Measured small(size_t candidate, std::vector<double>* by_place = nullptr);

    Measured crop(size_t candidate, size_t place);
    Measured whole(size_t candidate);

    /// The GPU time of a whole picture, measured again.
    double time(size_t candidate);

    /// Whether `crops` crops of the truth and of all candidates take less than half the time of their whole pictures. Each
    /// has the whole scene's vertices and shadows and a submission of its own: they can cost more.
    bool crops_pay(size_t crops);

  private:
    double draw(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop);
    ImageRgb picture(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop, double& ms);
    bool allowed(const StudyPoint& point) const;
    glm::uvec2 small_size() const;

    Chapter& chapter_;
    const KnobValues truth_;
    const Picture picture_;
    const FrameClock clock_;
    const KnobList knobs_;
    const KeptKnobs kept_;
    Frame small_frame_, crop_frame_, whole_frame_;
    ImageRgb small_truth_, whole_truth_;
    std::map<size_t, ImageRgb> crop_truths_;
    std::map<size_t, std::pair<Measured, std::vector<double>>> smalls_;
    std::map<std::pair<size_t, size_t>, Measured> crops_;
    std::map<size_t, Measured> wholes_;
    std::optional<std::pair<DrawTimes, DrawTimes>> takes_;  // the truth's estimated time; a candidate's
};

/// Crops below which nothing is known well enough.
constexpr size_t fewest_crops = 16;

}  // namespace lightwalk
