#include "common/app/study.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/error.h"
#include "common/files.h"
#include "common/measure/flip.h"
#include "common/measure/metrics.h"
#include "common/measure/statistics.h"
#include "common/scene/json_lines.h"

namespace lightwalk {
namespace {

using nlohmann::json;

std::string knob_text(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void apply(Chapter& chapter, const json& set) {
    for (const auto& [name, value] : set.items()) find_knob(chapter.knobs, name).set(knob_text(value));
}

void apply(Chapter& chapter, const StudyPoint& point) {
    if (!point.method.empty()) find_knob(chapter.knobs, "method").set(point.method);
    for (const auto& [name, value] : point.set) find_knob(chapter.knobs, name).set(value);
}

int rounds_of(const json& study) {
    const char* override = std::getenv("LIGHTWALK_STUDY_ROUNDS");
    if (!override) return study.value("rounds", 11);
    const int rounds = std::atoi(override);
    if (rounds < 1) throw InputError(std::string("LIGHTWALK_STUDY_ROUNDS is ") + override + ", expected 1 or more");
    return rounds;
}

// One scene of the study: its truth, then every point's error, then every point's time, round by round.
class SceneStudy {
  public:
    SceneStudy(const json& study, const Options& options, Chapter& chapter, Gpu& gpu, Frame& frame, std::string scene)
        : study_(study), options_(options), chapter_(chapter), gpu_(gpu), frame_(frame), scene_(std::move(scene)) {
        if (study.contains("size") && !options.size_given)
            size_ = {study["size"][0].get<unsigned>(), study["size"][1].get<unsigned>()};
        else
            size_ = options.size;
    }

    json run() {
        load_scene(chapter_, gpu_, scene_);
        const json& truth = study_.at("truth");
        const ImageRgb reference = picture(truth.at("set"));
        const double change =
            study_errors(picture(truth.at("doubled")), reference).at(study_.at("error_metric")).get<double>();
        if (!(change <= truth.at("most_change").get<double>()))
            throw Failure(scene_ + ": doubling the truth's samples changes it by " + json(change).dump() +
                          ", at most " + truth.at("most_change").dump() + " was expected");
        const std::vector<StudyPoint> points = study_points(study_);
        std::vector<json> errors;
        for (const StudyPoint& point : points) {
            reset();
            apply(chapter_, point);
            show_progress(scene_ + ": errors", errors.size(), points.size());
            errors.push_back(study_errors(reference, render_picture()));
        }
        return {{"doubling_change", change}, {"one_step", one_step(reference)}, {"points", time(points, errors)}};
    }

  private:
    void reset() {
        for (KnobBase* knob : chapter_.knobs) knob->reset();
        for (const auto& [name, value] : chapter_.scene.file.knobs) find_knob(chapter_.knobs, name).set(value);
    }
    ImageRgb render_picture() {
        render(chapter_, frame_, size_, options_.time_s, options_.seed);
        return read_hdr(gpu_, frame_.hdr);
    }
    ImageRgb picture(const json& set) {
        reset();
        apply(chapter_, set);
        return render_picture();
    }
    static json one_step(const ImageRgb& reference) {
        const Image8 codes = to_srgb8(reference);
        return study_errors(to_linear(codes), to_linear(one_step_away(codes)));
    }
    json time(const std::vector<StudyPoint>& points, const std::vector<json>& errors) {
        const int rounds = rounds_of(study_);
        std::vector<std::map<std::string, std::vector<double>>> samples(points.size());
        std::vector<std::vector<double>> totals(points.size());
        for (int round = -1; round < rounds; ++round) {  // the first only warms up
            show_progress(scene_ + ": times", static_cast<size_t>(round + 1), static_cast<size_t>(rounds + 1));
            for (size_t i = 0; i < points.size(); ++i) {
                reset();
                apply(chapter_, points[i]);
                render(chapter_, frame_, size_, options_.time_s, options_.seed);
                if (round < 0) continue;
                double total = 0;
                for (const PassTime& pass : frame_.times) {
                    samples[i][pass.name].push_back(pass.gpu_ms);
                    total += pass.gpu_ms;
                }
                totals[i].push_back(total);
            }
        }
        json result = json::array();
        for (size_t i = 0; i < points.size(); ++i) {
            const Quartiles q = quartiles(totals[i]);
            json per_pass = json::object(), knobs = json::object();
            for (const auto& [name, values] : samples[i]) per_pass[name] = median(values);
            for (const auto& [name, value] : points[i].set) {
                const json number = json::parse(value, nullptr, false);
                knobs[name] = number.is_number() ? number : json(value);
            }
            result.push_back(
                {{"scene", std::filesystem::path(scene_).stem().string()},
                 {"method", points[i].method},
                 {"knobs", knobs},
                 {"error", errors[i]},
                 {"time_ms",
                  {{"median", q.median}, {"q1", q.q1}, {"q3", q.q3}, {"rounds", rounds}, {"per_pass", per_pass}}}});
        }
        return result;
    }
    const json& study_;
    const Options& options_;
    Chapter& chapter_;
    Gpu& gpu_;
    Frame& frame_;
    std::string scene_;
    glm::uvec2 size_{};
};

// The method apart from the other knobs, as docs/study_format.md has it.
json truth_of(const json& study) {
    json knobs = study.at("truth").at("set");
    const json method = knobs.value("method", "");
    knobs.erase("method");
    return {{"method", method}, {"knobs", knobs}};
}

}  // namespace

std::vector<StudyPoint> study_points(const json& study) {
    std::vector<StudyPoint> points;
    for (const json& curve : study.at("curves")) {
        std::vector<StudyPoint> of_curve{{curve.value("method", ""), {}}};
        if (curve.contains("set"))
            for (const auto& [name, values] : curve["set"].items()) {
                std::vector<StudyPoint> next;
                for (const StudyPoint& point : of_curve)
                    for (const json& value : values.is_array() ? values : json::array({values})) {
                        next.push_back(point);
                        next.back().set.emplace_back(name, knob_text(value));
                    }
                of_curve = std::move(next);
            }
        points.insert(points.end(), of_curve.begin(), of_curve.end());
    }
    return points;
}

ImageRgb read_hdr(Gpu& gpu, const Image& hdr) {
    const std::vector<std::byte> texels = gpu.read_back(hdr);
    ImageRgb image(static_cast<int>(hdr.desc.size.x), static_cast<int>(hdr.desc.size.y));
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        uint64_t packed = 0;
        std::memcpy(&packed, texels.data() + 8 * i, 8);
        image.pixels[i] = glm::vec3(glm::unpackHalf4x16(packed));
    }
    return image;
}

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

void run_study(const Options& options, Chapter& chapter, Gpu& gpu) {
    const auto path = course_root() / "chapters" / chapter.name / "study.json";
    const std::string text = read_file(path);
    const json study = parse_json(text, path.string()).root;
    const std::filesystem::path partial = options.study + ".partial";
    const std::string identity = gpu.device.info.name + " " + gpu.device.info.driver + " " +
                                 std::to_string(hash_bytes(text)) + " " + std::to_string(rounds_of(study)) + " " +
                                 std::to_string(options.size.x) + "x" + std::to_string(options.size.y);
    json done = {{"identity", identity}, {"scenes", json::object()}};
    if (std::filesystem::exists(partial)) {
        const json before = json::parse(read_file(partial), nullptr, false);
        if (before.is_object() && before.value("identity", "") == identity) done = before;
    }
    Frame frame(gpu);
    for (const json& scene : study.at("scenes")) {
        const std::string name = scene.get<std::string>();
        if (done["scenes"].contains(name)) continue;
        done["scenes"][name] = SceneStudy(study, options, chapter, gpu, frame, name).run();
        write_file(partial, done.dump());
    }
    json result = {{"chapter", chapter.name},
                   {"title", study.at("title")},
                   {"subject", "frame"},
                   {"device", gpu.device.info.name},
                   {"driver", gpu.device.info.driver},
                   {"stage", study.at("stage")},
                   {"command", "./course study " + chapter.name.substr(0, 2) +
                                   (options.device.empty() ? "" : " --device " + options.device)},
                   {"truth", truth_of(study)},
                   {"error_metric", study.at("error_metric")},
                   {"time_unit", "ms"},
                   {"points", json::array()}};
    double worst = 0;
    for (const json& scene : study.at("scenes")) {
        const json& part = done["scenes"][scene.get<std::string>()];
        worst = std::max(worst, part.at("doubling_change").get<double>());
        result["one_step"] = part.at("one_step");
        for (const json& point : part.at("points")) result["points"].push_back(point);
    }
    result["truth"]["doubling_change"] = worst;
    write_file(options.study, result.dump(1) + "\n");
    std::filesystem::remove(partial);
    show_progress("written to " + options.study + "\n", 1, 1);
}

bool run_cpu_study(const Options& options, Chapter& chapter) {
    const auto path = course_root() / "chapters" / chapter.name / "study.json";
    json study = parse_json(read_file(path), path.string()).root;
    study["rounds"] = rounds_of(study);
    json result;
    if (!chapter.cpu_study(study, result)) return false;
    result["chapter"] = chapter.name;
    result["title"] = study.at("title");
    result["command"] = "./course study " + chapter.name.substr(0, 2);
    write_file(options.study, result.dump(1) + "\n");
    return true;
}

}  // namespace lightwalk
