#include "common/study/study.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include "common/app/clock_warmer.h"
#include "common/app/foreign_scene.h"
#include "common/app/headless.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/statistics.h"
#include "common/measure/flip.h"
#include "common/measure/metrics.h"
#include "common/scene/json_lines.h"
#include "common/study/need.h"
#include "common/study/subject.h"

namespace lightwalk {
namespace {

using nlohmann::json;

int rounds_of(const Options& options, int rounds_of_study) {
    const int rounds = options.study_rounds.value_or(rounds_of_study);
    if (rounds < 1) throw InputError("--study-rounds {}: expected 1 or more", rounds);
    return rounds;
}

std::set<std::string> metrics_of(const std::vector<json>& errors) {
    std::set<std::string> names;
    for (const json& error : errors)
        for (const auto& [name, value] : error.items()) names.insert(name);
    return names;
}

// One scene of the study: its truth, then every point's error, then every point's time, round by round.
class SceneStudy {
  public:
    SceneStudy(const StudyPlan& plan, const Options& options, Chapter& chapter, Frame& frame, const StudyScene& scene)
        : plan_(plan),
          chapter_(chapter),
          frame_(frame),
          scene_(scene),
          rounds_(rounds_of(options, plan.rounds)),
          picture_{
              options.size_given ? options.size : plan.size.value_or(options.size), options.time_s, options.seed, {}} {}

    json run() {
        load();
        set(plan_.truth);
        for (const StudyPoint& point : plan_.points)
            if (have_values(chapter_.all_knobs(), point.where)) points_.push_back(point);
        json doubling = json::object();
        const ImageRgb reference = plan_.pictures > 1 ? mean_of_seeds(doubling) : render_picture();
        if (plan_.doubled) doubling = double_samples(reference);
        std::vector<json> errors;
        for (const StudyPoint& point : points_) {
            set(point.all());
            show_progress(scene_.label + ": errors", errors.size(), points_.size());
            errors.push_back(study_errors(reference, render_picture()));
            if (plan_.budgets.empty()) errors.back().update(measured());
        }
        if (std::none_of(errors.begin(), errors.end(), [&](const json& e) { return e.contains(plan_.error_metric); }))
            throw InputError("error_metric is '{}', but no point of {} has it; points have: {}", plan_.error_metric,
                             scene_.label, fmt::join(metrics_of(errors), ", "));
        json result = {{"file", scene_.file},
                       {"set", as_json(scene_.set)},
                       {"doubling", doubling},
                       {"one_step", one_step(reference)},
                       {"points", time(errors)}};
        if (!plan_.budgets.empty()) {
            set({});
            result["choices"] = choose_candidates(chapter_, frame_.gpu, plan_, {plan_.budgets, picture_, plan_.crops});
        }
        return result;
    }

  private:
    // Applies the scene's settings before the chapter prepares; they override the scene file.
    void load() {
        for (KnobBase* knob : chapter_.all_knobs()) knob->reset();
        std::vector<std::pair<KnobBase*, bool>> pins;
        for (const auto& [name, value] : scene_.set) {
            KnobBase& knob = find_knob(chapter_.all_knobs(), name);
            pins.emplace_back(&knob, knob.pinned);
            knob.set(value);
            knob.pinned = true;
        }
        load_scene(chapter_, frame_.gpu, scene_.file);
        for (const auto& [knob, pinned] : pins) knob->pinned = pinned;
    }
    void set(const KnobValues& values) {
        const KnobList knobs = chapter_.all_knobs();
        for (KnobBase* knob : knobs) knob->reset();
        ForeignScene(scene_.file, chapter_.scene.file, chapter_.name, "this chapter")
            .set_knobs(chapter_.scene.file,
                       [&](const std::string& name) -> KnobBase& { return find_knob(knobs, name); });
        set_knobs(knobs, scene_.set);
        set_knobs(knobs, values);
        chapter_.forget_history();
    }
    // For its time: two frames are enough for one that has a history.
    void draw(const StudyPoint& point) {
        set(point.all());
        Picture picture = picture_;
        picture.gathered = 2;
        render(chapter_, frame_, picture);
    }
    ImageRgb render_picture(unsigned seed = 0) {
        Picture picture = picture_;
        picture.seed += seed;
        render(chapter_, frame_, picture);
        // With budgets the subject is the need rule, so the picture it judges counts.
        return read_linear(frame_.gpu, plan_.budgets.empty() ? chapter_.judged(frame_) : chapter_.written(frame_));
    }
    // The mean of the truth's pictures; `change`: how far the second half of them moves it.
    ImageRgb mean_of_seeds(json& change) {
        ImageRgb mean = render_picture(), half;
        for (int i = 1; i < plan_.pictures; ++i) {
            if (2 * i == plan_.pictures) half = mean;
            show_progress(scene_.label + ": truth", size_t(i), size_t(plan_.pictures));
            const ImageRgb next = render_picture(unsigned(i));
            for (size_t p = 0; p < mean.pixels.size(); ++p)
                mean.pixels[p] += (next.pixels[p] - mean.pixels[p]) / float(i + 1);
        }
        change = study_errors(mean, half);
        expect_small(change);
        return mean;
    }
    void expect_small(const json& change) const {
        if (!change.contains(plan_.error_metric))
            throw InputError("error_metric is '" + plan_.error_metric + "', which the truth does not have");
        if (!(change.at(plan_.error_metric).get<double>() <= plan_.most_change))
            throw Failure(scene_.label + ": doubling the truth's samples changes it by " +
                          change.at(plan_.error_metric).dump() + ", at most " + json(plan_.most_change).dump() +
                          " was expected");
    }
    // The chapter's own errors for the picture just rendered. Every picture sets all knobs, so changes here do not
    // last.
    json measured() {
        json own = json::object();
        chapter_.measure(frame_.gpu, picture_.size, own);
        static const json of_pictures = study_errors(ImageRgb(1, 1), ImageRgb(1, 1));
        for (const auto& [name, value] : own.items())
            if (of_pictures.contains(name) || !value.is_number())
                throw Failure("chapter " + chapter_.name + " measures '" + name + "' as " + value.dump() +
                              ": expected a number, under a name that no error of a picture has");
        return own;
    }
    // How far the truth moves with its samples doubled, in every metric. Knobs are the truth's before.
    json double_samples(const ImageRgb& reference) {
        const json before = measured();
        set(*plan_.doubled);
        json change = study_errors(render_picture(), reference);
        const json after = measured();
        for (const auto& [name, value] : after.items())
            if (before.contains(name)) change[name] = std::fabs(value.get<double>() - before.at(name).get<double>());
        expect_small(change);
        return change;
    }
    static json one_step(const ImageRgb& reference) {
        const Image8 codes = to_srgb8(reference);
        return study_errors(to_linear(codes), to_linear(one_step_away(codes)));
    }
    json time(const std::vector<json>& errors) {
        const std::vector<StudyPoint>& points = points_;
        std::vector<std::map<std::string, std::vector<double>>> samples(points.size());
        std::vector<std::vector<double>> totals(points.size());
        // A GPU that was idle while errors were computed runs at a low clock at first, for more than a round of fast
        // frames.
        ClockWarmer load(frame_.gpu);
        load.run(std::chrono::milliseconds(rounds_ > 1 ? 1500 : 0));
        if (rounds_ > 1)  // one is a test's, for which the pictures of the errors have warmed up
            for (const StudyPoint& point : points) draw(point);
        for (int round = 0; round < rounds_; ++round) {
            show_progress(scene_.label + ": times", static_cast<size_t>(round), static_cast<size_t>(rounds_));
            for (size_t i = 0; i < points.size(); ++i) {
                double total = 0;
                for (const auto& [name, ms] : times_of(points[i], load)) {
                    samples[i][name].push_back(ms);
                    total += ms;
                }
                totals[i].push_back(total);
            }
        }
        json result = json::array();
        for (size_t i = 0; i < points.size(); ++i) {
            const Quartiles q = quartiles(totals[i]);
            json per_pass = json::object(), knobs = as_json(scene_.set);
            for (const auto& [name, values] : samples[i]) per_pass[name] = median(values);
            knobs.update(as_json(points[i].set));
            if (!points[i].name.empty()) knobs[points[i].knob] = points[i].method;
            result.push_back(
                {{"scene", scene_.label},
                 {"method", points[i].shown()},
                 {"knobs", knobs},
                 {"error", errors[i]},
                 {"time_ms",
                  {{"median", q.median}, {"q1", q.q1}, {"q3", q.q3}, {"rounds", rounds_}, {"per_pass", per_pass}}}});
        }
        return result;
    }
    // Milliseconds of a point's passes; of those of its first frame alone, such as a table's, unless the plan leaves them
    // out. A GPU's are of a second frame: a table made by the processor lets the clock fall in the first.
    std::vector<std::pair<std::string, double>> times_of(const StudyPoint& point, ClockWarmer& load) {
        std::vector<std::pair<std::string, double>> first, second;
        const auto draw_into = [&](auto& times) {
            load.run();
            draw(point);
            for (const PassTime& pass : frame_.times) times.emplace_back(pass.name, pass.gpu_ms);
        };
        draw_into(first);
        if (frame_.gpu.device.software_paths && !plan_.each_frame) return first;
        draw_into(second);
        if (plan_.each_frame) return second;
        for (const auto& pass : first)
            if (std::ranges::find(frame_.times, pass.first, &PassTime::name) == frame_.times.end())
                second.push_back(pass);
        return second;
    }
    const StudyPlan& plan_;
    Chapter& chapter_;
    Frame& frame_;
    const StudyScene& scene_;
    const int rounds_;
    const Picture picture_;
    std::vector<StudyPoint> points_;  // the plan's points for this scene
};

// The method apart from the other knobs, as docs/study_format.md has it.
json truth_of(const StudyPlan& plan) {
    json knobs = as_json(plan.truth);
    const json method = knobs.value("method", "");
    knobs.erase("method");
    json truth = {{"method", method}, {"knobs", knobs}};
    if (plan.is_exact()) truth["exact"] = true;
    if (plan.pictures > 1) truth["pictures"] = plan.pictures;
    return truth;
}

std::string text_of(glm::uvec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

// The command that repeats the measurement.
std::string command_of(const Options& options, const Chapter& chapter) {
    return (options.study_file.empty()
                ? "./course study " + chapter.name.substr(0, 2)
                : "build/chapters/" + chapter.name + " --study FILE --study-file " + options.study_file) +
           (options.device.empty() ? "" : " --device " + options.device) +
           (options.size_given ? " --size " + text_of(options.size) : "");
}

}  // namespace

json study_errors(const ImageRgb& truth, const ImageRgb& test) {
    const ErrorSummary flip = summarize(flip_ldr(truth, test));
    const Difference d = difference(truth, test);
    return {{"flip_mean", flip.mean}, {"flip_p99", flip.p99}, {"rmse", d.rmse},   {"relative_rmse", d.relative_rmse},
            {"max", d.max},           {"nan", d.test.nan},    {"inf", d.test.inf}};
}

void show_progress(const std::string& what, size_t done, size_t of) {
    const bool terminal = isatty(STDERR_FILENO);
    if (!terminal && done != 0 && done != of) return;
    constexpr size_t width = 30;
    const size_t filled = of ? done * width / of : width;
    std::fprintf(stderr, "%s[%s%s] %zu/%zu %s%s", terminal ? "\r\033[K" : "", std::string(filled, '#').c_str(),
                 std::string(width - filled, '.').c_str(), done, of, what.c_str(), terminal ? "" : "\n");
}

json measure_study(const std::string& text, const std::string& file, const Options& options, Chapter& chapter,
                   Gpu& gpu) {
    const StudyPlan plan = read_study(parse_json(text, file), chapter.all_knobs());
    const glm::uvec2 size = options.size_given ? options.size : plan.size.value_or(options.size);
    const std::filesystem::path partial = options.study + ".partial";
    const std::string identity = "2 " + gpu.device.info.name + " " + gpu.device.info.driver + " " +
                                 std::to_string(hash_bytes(text)) + " " +
                                 std::to_string(rounds_of(options, plan.rounds)) + " " + text_of(size);
    json done = {{"identity", identity}, {"scenes", json::object()}};
    if (std::filesystem::exists(partial)) {
        const json before = json::parse(read_file(partial), nullptr, false);
        if (before.is_object() && before.value("identity", "") == identity) done = before;
    }
    Frame frame(gpu);
    for (const StudyScene& scene : plan.scenes) {
        if (done["scenes"].contains(scene.label)) continue;
        done["scenes"][scene.label] = SceneStudy(plan, options, chapter, frame, scene).run();
        write_file(partial, done.dump(-1, ' ', false, json::error_handler_t::replace));
    }
    json result = {{"chapter", chapter.name},
                   {"title", plan.title},
                   {"subject", "frame"},
                   {"device", gpu.device.info.name},
                   {"driver", gpu.device.info.driver},
                   {"stage", plan.stage},
                   {"size", {size.x, size.y}},
                   {"command", command_of(options, chapter)},
                   {"truth", truth_of(plan)},
                   {"error_metric", plan.error_metric},
                   {"time_unit", "ms"},
                   {"scenes", done["scenes"]},
                   {"points", json::array()}};
    if (plan.points[0].knob != "method") result["method_knob"] = plan.points[0].knob;
    if (!plan.charts.is_null()) result["charts"] = plan.charts;
    if (!plan.metrics.empty()) result["metrics"] = plan.metrics;
    double worst = 0;
    for (const StudyScene& scene : plan.scenes) {
        json& part = result["scenes"][scene.label];
        if (!plan.is_exact()) worst = std::max(worst, part.at("doubling").at(plan.error_metric).get<double>());
        for (const json& point : part.at("points")) result["points"].push_back(point);
        part.erase("points");
    }
    if (!plan.is_exact()) result["truth"]["doubling_change"] = worst;
    return result;
}

namespace {

// Of something else than frames, without a device.
void run_subject_study(const Options& options, Chapter& chapter, const std::filesystem::path& file) {
    json study = parse_json(read_file(file), file.string()).root;
    study["rounds"] = rounds_of(options, study.value("rounds", 11));
    json result;
    chapter.subject->measure(study, result);
    result["chapter"] = chapter.name;
    result["title"] = study.at("title");
    result["command"] = "./course study " + chapter.name.substr(0, 2);
    if (study.contains("charts")) result["charts"] = study["charts"];
    write_file(options.study, result.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace

int run_study(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu) {
    check_writable(options.study);
    const std::filesystem::path file = options.study_file.empty()
                                           ? course_root() / "chapters" / chapter.name / "study.json"
                                           : std::filesystem::path(options.study_file);
    if (chapter.subject) {
        run_subject_study(options, chapter, file);
        return 0;
    }
    gpu = make_gpu(options);
    const std::string shown = std::filesystem::relative(file, course_root()).string();
    const json result =
        measure_study(read_file(file), options.study_file.empty() ? shown : file.string(), options, chapter, *gpu);
    write_file(options.study, result.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    std::filesystem::remove(options.study + ".partial");
    show_progress("written to " + options.study + "\n", 1, 1);
    gpu->device.check_validation();
    return 0;
}

}  // namespace lightwalk
