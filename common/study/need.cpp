#include "common/study/need.h"

#include <chrono>
#include <cmath>

#include "common/base/statistics.h"
#include "common/study/cheapest.h"
#include "common/study/need_pictures.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// Errors count as known to lie within so many standard errors of their estimate: 99.9% each, where they are normally
// distributed, so that with a few dozen candidates all are, with 95%.
constexpr double confidence = 3.0;
constexpr size_t first_crops = 4;       // show only who is far over the budget
constexpr double evenly = 0.3;          // of the crops: spread over the picture, wherever the small picture differs
constexpr double clearly_dearer = 1.5;  // rough times are known so well
constexpr size_t timing_rounds = 5, most_timed = 6;

struct Candidate {
    size_t number = 0;
    double rough_ms = 0;  // GPU time of everything drawn for all candidates alike
    double lower = 0, upper = INFINITY, error = NAN;
    Estimate estimate{};
    std::vector<double> frames_ms{};
    double time_ms = 0;
    bool enough(double budget) const { return upper <= budget; }
    bool probably_enough(double budget) const { return enough(budget) || error <= 0.5 * budget; }
};

class NeedRule {
  public:
    NeedRule(NeedPictures& pictures, double budget, bool always_crops) : pictures_(pictures), budget_(budget) {
        for (size_t i = 0; i < pictures.candidates.size(); ++i) candidates_.push_back({.number = i});
        const auto start = std::chrono::steady_clock::now();
        // 1. Small pictures show where methods differ and roughly what they cost. Then crops, more for errors closer
        //    to the budget. A budget of 0 requires every pixel.
        const bool large = !pictures.places.empty();
        if (large)
            for (Candidate& c : candidates_) c.rough_ms = pictures.small(c.number).ms;
        if (large && budget > 0 && (always_crops || pictures.crops_pay(fewest_crops))) look_at_crops();
        // 2. Whole pictures, with exact errors, where crops are inconclusive or too expensive.
        look_at_whole_pictures();
        // 3. The time of whole pictures, for candidates that may be the cheapest.
        measure_times();
        choose();
        choosing_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }

    const StudyPoint& choice() const { return pictures_.candidates[choice_->number]; }

    json explanation() const {
        json all = json::array();
        for (const Candidate& c : candidates_) all.push_back(as_json(c));
        return {{"budget", budget_},
                {"error_metric", "flip_mean"},
                {"crops", crops_},
                {"candidates", all},
                {"choice", as_json(*choice_)},
                {"none_would_do", !choice_->enough(budget_)},
                {"truth_ms", crops_ ? pictures_.truth_crops_ms : pictures_.truth_ms},
                {"choosing_ms", choosing_ms_}};
    }

  private:
    // The more where the small pictures of candidates near the budget differ from the truth's.
    std::vector<double> chances() {
        const std::vector<CropPlace>& places = pictures_.places;
        std::vector<double> wanted(places.size()), errors;
        double all = 0;
        for (const Candidate& c : candidates_) {
            const double error = pictures_.small(c.number, &errors).error;
            if (!(error > 0)) continue;
            const double away = std::log(error / budget_), weight = 1.0 / (1.0 + away * away);
            for (size_t i = 0; i < places.size(); ++i) {
                const double share = weight * places[i].share * errors[i] / error;
                wanted[i] += share;
                all += share;
            }
        }
        for (size_t i = 0; i < places.size(); ++i)
            wanted[i] = all > 0 ? evenly * places[i].share + (1.0 - evenly) * wanted[i] / all : places[i].share;
        return wanted;
    }

    // As many again, until it is clear which is the cheapest, or whole pictures cost no more.
    void look_at_crops() {
        const std::vector<double> chance = chances();
        const size_t most = std::min<size_t>(64, pictures_.places.size() / 4);
        for (size_t look = 0; 2 * crops_ <= most && (crops_ < fewest_crops || anything_matters()); ++look) {
            const double start = 0.5 + golden_ratio * static_cast<double>(look);
            const size_t count = crops_ ? crops_ : first_crops;
            const std::vector<size_t> drawn = draw_places(chance, count, start - std::floor(start));
            for (Candidate& c : candidates_) {
                if (c.estimate.count() < crops_ || !matters(c)) continue;
                for (const size_t at : drawn) {
                    const auto [error, ms] = pictures_.crop(c.number, at);
                    c.estimate.add(error, pictures_.places[at].share, chance[at]);
                    if (look == 0) c.rough_ms += ms;
                }
            }
            crops_ += count;
            for (Candidate& c : candidates_)
                if (c.estimate.count() == crops_) judge(c);
        }
    }

    void judge(Candidate& c) {
        c.error = c.estimate.mean();
        const double doubt = confidence * c.estimate.standard_error();
        c.lower = c.error - doubt;
        // Where no crop has found an error, and the small picture has one, the crops have missed it.
        if (crops_ >= fewest_crops) c.upper = c.error > 0 ? c.error + doubt : pictures_.small(c.number).error;
    }

    // Whether it is not known to be within the budget or over it, and could be the cheapest.
    bool matters(const Candidate& c) const {
        if (c.enough(budget_) || c.lower > budget_) return false;
        return std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
            return other.probably_enough(budget_) && other.rough_ms * clearly_dearer < c.rough_ms;
        });
    }
    bool anything_matters() const {
        return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) { return matters(c); });
    }

    // The cheapest first; candidates clearly slower than a sufficient one are not refined.
    void look_at_whole_pictures() {
        std::vector<Candidate*> order;
        for (Candidate& c : candidates_) order.push_back(&c);
        std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->rough_ms < b->rough_ms; });
        for (Candidate* c : order)
            if (matters(*c)) c->error = c->lower = c->upper = pictures_.whole(c->number).error;
        if (pictures_.places.empty())  // a small picture: its first time has compiled, the second one is rough
            for (Candidate& c : candidates_) c.rough_ms = pictures_.time(c.number);
    }

    // Interleaved; each round omits candidates that the previous one showed to be slower.
    void measure_times() {
        std::vector<Candidate*> left;
        for (Candidate& c : candidates_)
            if (c.enough(budget_)) left.push_back(&c);
        const auto drop = [&](auto time_of, double factor) {
            double least = INFINITY;
            for (const Candidate* c : left) least = std::min(least, time_of(*c));
            std::erase_if(left, [&](const Candidate* c) { return time_of(*c) > factor * least; });
        };
        drop([](const Candidate& c) { return c.rough_ms; }, clearly_dearer);
        std::stable_sort(left.begin(), left.end(), [](auto* a, auto* b) { return a->rough_ms < b->rough_ms; });
        left.resize(std::min(left.size(), most_timed));
        for (size_t round = 0; round < timing_rounds && left.size() > (round ? 1u : 0u); ++round) {
            for (Candidate* c : left) c->frames_ms.push_back(pictures_.time(c->number));
            drop([](const Candidate& c) { return median(c.frames_ms); }, round ? 1.1 : 1.3);
        }
        // Of the others the time is estimated: as much longer than that of those measured as the rough one is.
        double rough = 0, measured = 0;
        for (Candidate& c : candidates_)
            if (!c.frames_ms.empty()) {
                rough += c.rough_ms;
                measured += c.time_ms = median(c.frames_ms);
            }
        for (Candidate& c : candidates_)
            if (c.frames_ms.empty()) c.time_ms = rough > 0 ? c.rough_ms * measured / rough : c.rough_ms;
    }

    void choose() {
        std::vector<Measured> all;
        for (const Candidate& c : candidates_) all.push_back({c.error, c.time_ms, !c.frames_ms.empty()});
        choice_ = &candidates_[cheapest(all)];
    }

    json as_json(const Candidate& c) const {
        const StudyPoint& point = pictures_.candidates[c.number];
        return {{"method", point.method},
                {"knobs", lightwalk::as_json(point.set)},
                {"error", std::isnan(c.error) ? json() : json(c.error)},
                {"error_upper", std::isfinite(c.upper) ? json(c.upper) : json()},
                {"time_ms", c.time_ms},
                {"enough", c.enough(budget_)}};
    }

    NeedPictures& pictures_;
    const double budget_;
    std::vector<Candidate> candidates_;
    const Candidate* choice_ = nullptr;
    size_t crops_ = 0;
    double choosing_ms_ = 0;
};

}  // namespace

std::vector<json> choose_candidates(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const NeedQuestion& question) {
    std::vector<json> explanations;
    KnobValues chosen;
    {
        NeedPictures pictures(chapter, gpu, plan, question.picture, question.clock);
        pictures.between = question.between;
        for (const double budget : question.budgets) {
            const NeedRule rule(pictures, budget, question.crops);
            explanations.push_back(rule.explanation());
            chosen = rule.choice().all();
        }
    }
    set_knobs(chapter.all_knobs(), chosen);
    chapter.forget_history();
    return explanations;
}

}  // namespace lightwalk
