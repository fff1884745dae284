#include "common/study/need.h"

#include <chrono>
#include <cmath>

#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/measure/statistics.h"
#include "common/study/crops.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// Errors count as known to lie within so many standard errors of their estimate: 99.9% each, where they are normally
// distributed, so that with a few dozen candidates all are, with 95%.
constexpr double confidence = 3.0;
constexpr size_t first_crops = 4, fewest_crops = 16, most_crops = 64;  // fewer show only who is far over the budget
constexpr unsigned reduction = 4;                                      // of the small picture's sides
constexpr double evenly = 0.3;          // of the crops: spread over the picture, wherever the small picture differs
constexpr double clearly_dearer = 1.5;  // rough times are known so well
constexpr double as_fast = 1.02;        // and measured ones so well
constexpr size_t timing_rounds = 5, most_timed = 6;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct Candidate {
    StudyPoint point;
    double small_error = 0;  // of the small picture
    std::vector<double> small_map;
    Estimate estimate;
    double error = std::numeric_limits<double>::quiet_NaN(), lower = 0, upper = std::numeric_limits<double>::infinity();
    double rough_ms = 0;            // of the same small pictures and crops for all
    std::vector<double> frames_ms;  // of whole pictures
    double time_ms = 0;
    bool enough(double budget) const { return upper <= budget; }
    bool probably_enough(double budget) const { return enough(budget) || error <= 0.5 * budget; }
    bool open(double budget) const { return lower <= budget && budget < upper; }
};

class NeedRule {
  public:
    NeedRule(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const NeedQuestion& question)
        : chapter_(chapter),
          plan_(plan),
          question_(question),
          whole_(question.picture.size),
          knobs_(chapter.all_knobs()),
          kept_(knobs_),
          small_frame_(gpu),
          crop_frame_(gpu),
          whole_frame_(gpu) {
        for (const StudyPoint& point : plan.candidates)
            if (allowed(point))
                candidates_.push_back({.point = point, .small_map = {}, .estimate = {}, .frames_ms = {}});
        if (candidates_.empty())
            throw InputError("no candidate of chapter " + chapter.name + " agrees with the knobs that are set");
    }

    json run() {
        const auto start = std::chrono::steady_clock::now();
        // 1. All in small: where methods differ, and what they cost about.
        look_at_small_pictures();
        // 2. Crops, the more the closer an error is to the budget.
if (crops_pay()) look_at_crops();
        // 3. What crops leave open, and what they cost too much for: whole pictures, whose errors are exact.
        look_at_whole_pictures();
        // 4. The time of whole pictures, of those that may be the cheapest.
measure_times();
        const Candidate& best = choice();
        const bool none = !best.enough(question_.budget);
        kept_.put_back();
        set_knobs(knobs_, best.point.all());
        chapter_.forget_history();
        return {{"budget", question_.budget},
                {"error_metric", "flip_mean"},
                {"crops", crops_},
                {"candidates", table()},
                {"choice", as_json(best)},
                {"none_would_do", none},
                {"truth_ms", truth_ms_},
                {"choosing_ms", milliseconds_since(start)}};
    }

  private:
    bool allowed(const StudyPoint& point) const {
        if (!have_values(knobs_, point.where)) return false;
        const KnobValues values = point.all();
        return std::all_of(values.begin(), values.end(), [&](const auto& value) {
            return !find_knob(knobs_, value.first).pinned || have_values(knobs_, {value});
        });
    }

    // Adds its GPU time to `ms`.
    void draw(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop, double& ms) {
        kept_.put_back();
        set_knobs(knobs_, values);
        chapter_.forget_history();
        Picture picture = question_.picture;
        picture.size = size;
        picture.crop = crop;
        render(chapter_, frame, picture);
        for (const PassTime& pass : frame.times) ms += pass.gpu_ms;
    }
    // The picture as it is judged.
    ImageRgb picture(const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop, double& ms) {
        draw(values, frame, size, crop, ms);
        return read_linear(frame.gpu, chapter_.judged(frame));
    }

    // FLIP takes longer than to see that there is no difference.
    static ErrorMap error_map(const ImageRgb& truth, const ImageRgb& test, float degree = default_pixels_per_degree) {
        if (truth.pixels != test.pixels) return flip_ldr(truth, test, degree);
        return {truth.width, truth.height, std::vector<float>(truth.pixels.size())};
    }

    void look_at_small_pictures() {
        if (!large()) return;
        const glm::uvec2 size = small_size();
        const float degree = default_pixels_per_degree / float(reduction);  // as large to the eye
        double ms = 0;
        const ImageRgb truth = picture(plan_.truth, small_frame_, size, {}, ms);
        for (Candidate& c : candidates_) {
            double compiling = 0;
            const ErrorMap map = error_map(truth, picture(c.point.all(), small_frame_, size, {}, compiling), degree);
            c.small_error = summarize(map).mean;
            if (large())
                for (const CropPlace& place : places()) c.small_map.push_back(mean_over(map, whole_, place));
        }
        for (Candidate& c : candidates_) draw(c.point.all(), small_frame_, size, {}, c.rough_ms);
    }

    glm::uvec2 small_size() const { return glm::max(whole_ / reduction, 1u); }
    bool large() const { return whole_.x >= 2 * crop_px && whole_.y >= 2 * crop_px; }

    // Each crop has the whole scene's vertices and a submission: many of them can cost more than a whole picture. A
    // budget of 0 is a matter of every pixel.
    bool crops_pay() {
        const size_t pixels = size_t(whole_.x) * whole_.y, drawn = fewest_crops * crop_px * crop_px;
        if (!large() || question_.budget == 0 || drawn > pixels / 2) return false;
        if (question_.crops) return true;
        const auto time = [&](const KnobValues& values, Frame& frame, glm::uvec2 size, const Crop& crop) {
            double ms = 0;
            draw(values, frame, size, crop, ms);
            const auto start = std::chrono::steady_clock::now();
            draw(values, frame, size, crop, ms);
            return milliseconds_since(start);
        };
        const glm::uvec2 small = small_size();
        const double crop_ms =
            time(plan_.truth, crop_frame_, glm::uvec2(crop_px), {.whole = whole_, .origin = (whole_ - crop_px) / 2u});
        // A truth that is slow is not drawn whole just to know that: its small picture's time grows as the cheapest
        // candidate's does.
        const KnobValues cheap = std::min_element(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) {
                                     return a.rough_ms < b.rough_ms;
                                 })->point.all();
        const double growth = time(cheap, whole_frame_, whole_, {}) / time(cheap, small_frame_, small, {});
        return double(fewest_crops) * crop_ms < 0.5 * growth * time(plan_.truth, small_frame_, small, {});
    }

    const std::vector<CropPlace>& places() {
        if (places_.empty()) places_ = cut(whole_);
        return places_;
    }

    // Where the small pictures of candidates near the budget differ from the truth's.
    std::vector<double> chances() {
        std::vector<double> wanted(places().size(), 0.0);
        for (const Candidate& c : candidates_) {
            double sum = 0;
            for (size_t i = 0; i < wanted.size(); ++i) sum += places()[i].share * c.small_map[i];
            if (!(sum > 0)) continue;
            const double away = std::log(sum / question_.budget);
            for (size_t i = 0; i < wanted.size(); ++i)
                wanted[i] += places()[i].share * c.small_map[i] / sum / (1.0 + away * away);
        }
        double sum = 0;
        for (const double w : wanted) sum += w;
        for (size_t i = 0; i < wanted.size(); ++i)
            wanted[i] = sum > 0 ? evenly * places()[i].share + (1.0 - evenly) * wanted[i] / sum : places()[i].share;
        return wanted;
    }

    void look_at_crops() {
        const std::vector<double> chance = chances();
        std::map<size_t, ImageRgb> truths;
        std::map<std::pair<size_t, size_t>, double> errors;  // by candidate and place
        for (size_t count = first_crops, look = 0; crops_ < most_crops; count = crops_, ++look) {
            // Where a golden ratio's multiples start is spread evenly, however many there are.
            const double start = 0.5 + 0.6180339887 * static_cast<double>(look);
            const std::vector<size_t> drawn = draw_places(chance, count, start - std::floor(start));
            for (const size_t at : drawn) {
                const CropPlace& place = places()[at];
                const Crop crop{.whole = whole_, .origin = place.origin};
                const glm::uvec2 size(crop_px);
                if (!truths.count(at)) truths[at] = picture(plan_.truth, crop_frame_, size, crop, truth_ms_);
                for (size_t i = 0; i < candidates_.size(); ++i) {
                    Candidate& c = candidates_[i];
                    if (crops_ && (c.estimate.count() < crops_ || !matters(c))) continue;
                    if (!errors.count({i, at})) {
                        double ms = 0;
                        errors[{i, at}] = mean_of_crop(
                            error_map(truths[at], picture(c.point.all(), crop_frame_, size, crop, ms)), place);
                        if (!crops_) c.rough_ms += ms;
                    }
                    c.estimate.add(errors[{i, at}], place.share, chance[at]);
                }
            }
            crops_ += count;
            for (Candidate& c : candidates_)
                if (c.estimate.count() == crops_) judge(c);
            if (crops_ < fewest_crops) continue;
            if (std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) { return matters(c); }))
                return;
            // As many again, unless by then whole pictures are no dearer.
            if (2 * crops_ * crop_px * crop_px > size_t(whole_.x) * whole_.y / 2) return;
        }
    }

    void judge(Candidate& c) const {
        c.error = c.estimate.mean();
        const double doubt = confidence * c.estimate.standard_error();
        c.lower = c.error - doubt;
        // Where no crop has found an error, and the small picture has one, the crops have missed it.
        if (crops_ >= fewest_crops) c.upper = c.error > 0 ? c.error + doubt : c.small_error;
    }

    // Whether it is open if it is within the budget, and it could be the cheapest that is.
    bool matters(const Candidate& c) const {
        if (!c.open(question_.budget)) return false;
        return std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
            return other.probably_enough(question_.budget) && other.rough_ms * clearly_dearer < c.rough_ms;
        });
    }

    // The cheapest first: what is clearly dearer than one that is enough stays as it is.
    void look_at_whole_pictures() {
        std::vector<Candidate*> order;
        for (Candidate& c : candidates_) order.push_back(&c);
        std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->rough_ms < b->rough_ms; });
        ImageRgb truth;
        double truth_ms = 0;
        for (Candidate* c : order) {
            if (!matters(*c)) continue;
            if (truth.pixels.empty()) truth = picture(plan_.truth, whole_frame_, whole_, {}, truth_ms);
            double ms = 0;
            c->error = c->lower = c->upper =
                summarize(error_map(truth, picture(c->point.all(), whole_frame_, whole_, {}, ms))).mean;
        }
        if (crops_ == 0) truth_ms_ = truth_ms;
    }

    // Interleaved, and each round without those that the round before showed to be slower.
    void measure_times() {
        std::vector<Candidate*> left;
        for (Candidate& c : candidates_)
            if (c.enough(question_.budget)) left.push_back(&c);
        const auto drop = [&](auto time_of, double factor) {
            double least = INFINITY;
            for (const Candidate* c : left) least = std::min(least, time_of(*c));
            std::erase_if(left, [&](const Candidate* c) { return time_of(*c) > factor * least; });
        };
        drop([](const Candidate& c) { return c.rough_ms; }, clearly_dearer);
        std::stable_sort(left.begin(), left.end(), [](auto* a, auto* b) { return a->rough_ms < b->rough_ms; });
        left.resize(std::min(left.size(), most_timed));
        for (size_t round = 0; round < timing_rounds && left.size() > (round ? 1u : 0u); ++round) {
            for (Candidate* c : left) {
                double ms = 0;
                draw(c->point.all(), whole_frame_, whole_, {}, ms);
                c->frames_ms.push_back(ms);
            }
            drop([](const Candidate& c) { return median(c.frames_ms); }, round ? 1.1 : 1.3);
        }
        // Of the others the time is estimated: as much longer than that of those measured as the rough one is.
        double rough = 0, measured = 0;
        for (Candidate& c : candidates_)
            if (!c.frames_ms.empty()) rough += c.rough_ms, measured += c.time_ms = median(c.frames_ms);
        for (Candidate& c : candidates_)
            if (c.frames_ms.empty()) c.time_ms = rough > 0 ? c.rough_ms * measured / rough : c.rough_ms;
    }

    const Candidate& choice() const {
        const Candidate *fastest = nullptr, *best = nullptr;
        for (const Candidate& c : candidates_)
            if (!c.frames_ms.empty() && (!fastest || c.time_ms < fastest->time_ms)) fastest = &c;
        // The most accurate: of all, or of those that are as fast.
        for (const Candidate& c : candidates_)
            if (!fastest || (!c.frames_ms.empty() && c.time_ms <= as_fast * fastest->time_ms))
                if (!best || !(c.error >= best->error)) best = &c;
        return *best;
    }

    json as_json(const Candidate& c) const {
        return {{"method", c.point.method},
                {"knobs", lightwalk::as_json(c.point.set)},
                {"error", std::isnan(c.error) ? json() : json(c.error)},
                {"error_upper", std::isfinite(c.upper) ? json(c.upper) : json()},
                {"time_ms", c.time_ms},
                {"enough", c.enough(question_.budget)}};
    }
    json table() const {
        json all = json::array();
        for (const Candidate& c : candidates_) all.push_back(as_json(c));
        return all;
    }

    Chapter& chapter_;
    const StudyPlan& plan_;
    const NeedQuestion& question_;
    const glm::uvec2 whole_;
    const KnobList knobs_;
    const KeptKnobs kept_;
    Frame small_frame_, crop_frame_, whole_frame_;
    std::vector<Candidate> candidates_;
    std::vector<CropPlace> places_;
    size_t crops_ = 0;
    double truth_ms_ = 0;
};

}  // namespace

json choose_candidate(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const NeedQuestion& question) {
    return NeedRule(chapter, gpu, plan, question).run();
}

}  // namespace lightwalk
