#include "common/study/need_pictures.h"

#include <chrono>

#include "common/app/read_picture.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr unsigned reduction = 4;  // of the small picture's sides

// FLIP takes longer than to see that there is no difference.
ErrorMap error_map(const ImageRgb& truth, const ImageRgb& test, float degree = default_pixels_per_degree) {
    if (truth.pixels != test.pixels) return flip_ldr(truth, test, degree);
    return {truth.width, truth.height, std::vector<float>(truth.pixels.size())};
}

double wall_ms(const std::function<void()>& what) {
    const auto start = std::chrono::steady_clock::now();
    what();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

NeedPictures::NeedPictures(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const Picture& picture, FrameClock clock)
    : places(large(picture.size) ? cut(picture.size) : std::vector<CropPlace>()),
      chapter_(chapter),
      truth_(plan.truth),
      picture_(picture),
      clock_(std::move(clock)),
      knobs_(chapter.all_knobs()),
      kept_(knobs_),
      small_frame_(gpu),
      crop_frame_(gpu),
      whole_frame_(gpu) {
    chapter_.tries_knobs = true;
    for (const StudyPoint& point : plan.candidates)
        if (allowed(point)) candidates.push_back(point);
    if (!candidates.empty()) return;
    chapter_.tries_knobs = false;
    throw InputError("no candidate of chapter " + chapter.name + " agrees with the knobs that are set");
}

NeedPictures::~NeedPictures() { chapter_.tries_knobs = false; }

bool NeedPictures::allowed(const StudyPoint& point) const {
    if (!have_values(knobs_, point.where)) return false;
    const KnobValues values = point.all();
    return std::all_of(values.begin(), values.end(), [&](const auto& value) {
        return !find_knob(knobs_, value.first).pinned || have_values(knobs_, {value});
    });
}

bool NeedPictures::large(glm::uvec2 whole) {
    return std::min(whole.x, whole.y) >= crop_px && size_t(whole.x) * whole.y >= 2 * fewest_crops * crop_px * crop_px;
}

glm::uvec2 NeedPictures::small_size() const { return glm::max(picture_.size / reduction, 1u); }

double NeedPictures::draw(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop) {
    if (between) between();
    kept_.put_back();
    set_knobs(knobs_, values);
    chapter_.forget_history();
    Picture picture = picture_;
    picture.size = size;
    picture.crop = crop;
    render(chapter_, frame, picture);
    return clock_(frame);
}

// As it would be written: a budget is one of the picture that a person gets.
ImageRgb NeedPictures::picture(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop, double& ms) {
    ms += draw(values, frame, size, crop);
    return read_linear(frame.gpu, chapter_.written(frame));
}

NeedPictures::Measured NeedPictures::small(size_t candidate, std::vector<double>* by_place) {
    auto [it, added] = smalls_.try_emplace(candidate);
    auto& [measured, errors] = it->second;
    if (added) {
        double compiling = 0;
        const KnobValues values = candidates[candidate].all();
        if (small_truth_.pixels.empty()) small_truth_ = picture(truth_, small_frame_, small_size(), {}, compiling);
        const ErrorMap map = error_map(small_truth_, picture(values, small_frame_, small_size(), {}, compiling),
                                       default_pixels_per_degree / float(reduction));
        measured = {summarize(map).mean, draw(values, small_frame_, small_size(), {})};
        for (const CropPlace& place : places) errors.push_back(mean_over(map, picture_.size, place));
    }
    if (by_place) *by_place = errors;
    return measured;
}

NeedPictures::Measured NeedPictures::crop(size_t candidate, size_t place) {
    auto [it, added] = crops_.try_emplace({candidate, place});
    if (!added) return it->second;
    const Crop crop{.whole = picture_.size, .origin = places[place].origin};
    const glm::uvec2 size(crop_px);
    ImageRgb& truth = crop_truths_[place];
    if (truth.pixels.empty()) truth = picture(truth_, crop_frame_, size, crop, truth_crops_ms);
    const ImageRgb test = picture(candidates[candidate].all(), crop_frame_, size, crop, it->second.ms);
    it->second.error = mean_of_crop(error_map(truth, test), places[place]);
    return it->second;
}

NeedPictures::Measured NeedPictures::whole(size_t candidate) {
    auto [it, added] = wholes_.try_emplace(candidate);
    if (!added) return it->second;
    const glm::uvec2 size = picture_.size;
    if (whole_truth_.pixels.empty()) whole_truth_ = picture(truth_, whole_frame_, size, {}, truth_ms);
    const ImageRgb test = picture(candidates[candidate].all(), whole_frame_, size, {}, it->second.ms);
    it->second.error = summarize(error_map(whole_truth_, test)).mean;
    return it->second;
}

double NeedPictures::time(size_t candidate) {
    return draw(candidates[candidate].all(), whole_frame_, picture_.size, {});
}

bool NeedPictures::crops_pay(size_t crops) {
    if (!takes_) {
        const auto second_time = [&](const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop) {
            draw(values, frame, size, crop);
            return wall_ms([&] { draw(values, frame, size, crop); });
        };
        size_t fastest = 0;
        for (size_t i = 1; i < candidates.size(); ++i)
            if (small(i).ms < small(fastest).ms) fastest = i;
        // A truth that is slow is not drawn whole just to know that: its small picture's time grows as the fastest
        // candidate's does.
        const KnobValues fast = candidates[fastest].all();
        const double whole = second_time(fast, whole_frame_, picture_.size, {});
        const double growth = whole / second_time(fast, small_frame_, small_size(), {});
        const Crop middle{.whole = picture_.size, .origin = (picture_.size - crop_px) / 2u};
        const glm::uvec2 size(crop_px);
        takes_ = {{second_time(truth_, crop_frame_, size, middle),
                   growth * second_time(truth_, small_frame_, small_size(), {})},
                  {second_time(fast, crop_frame_, size, middle), whole}};
    }
    return crops_are_cheaper(crops, takes_->first, takes_->second, candidates.size());
}

}  // namespace lightwalk
