// --method auto: applies the need rule while a scene is loaded, and reports the result.
#include <cstdio>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/base/toggle_scope.h"
#include "common/study/need.h"
#include "common/study/study.h"
#include "common/study/subject.h"

namespace lightwalk {
namespace {

using nlohmann::json;

std::string text_of(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

KnobValues knobs_of(const json& point, const std::string& method_knob) {
    KnobValues values;
    if (const std::string method = point.at("method"); !method.empty()) values.emplace_back(method_knob, method);
    if (point.contains("knobs"))
        for (const auto& [name, value] : point["knobs"].items()) values.emplace_back(name, text_of(value));
    return values;
}

std::string number(const json& value, const char* format) {
    char text[64];
    if (!value.is_number()) return "-";
    std::snprintf(text, sizeof text, format, value.get<double>());
    return text;
}

void print_text(const json& said, const std::string& method_knob) {
    std::printf("%-36s %10s %10s %10s  %s\n", method_knob.c_str(), said["error_metric"].get<std::string>().c_str(),
                "at most", "ms", "enough");
    for (const json& c : said["candidates"]) {
        std::string name = c["method"];
        for (const auto& [knob, value] : c["knobs"].items()) name += " " + knob + " " + text_of(value);
        std::printf("%-36s %10s %10s %10s  %s\n", name.c_str(), number(c["error"], "%.5f").c_str(),
                    number(c["error_upper"], "%.5f").c_str(), number(c["time_ms"], "%.3f").c_str(),
                    c["enough"] == true ? "yes" : "");
    }
    if (const json& crops = said["crops"]; crops != 0)
        std::printf("measured on %s crops; open cases, and times, on whole pictures\n", crops.dump().c_str());
    std::string options;
    for (const auto& [name, value] : knobs_of(said["choice"], method_knob))
        options += name == method_knob ? "--" + name + " " + value : " --set " + name + "=" + value;
    std::printf("choice: %s%s\n", options.c_str(),
                said["none_would_do"] == true ? " (none would do within the budget: the most accurate)" : "");
}

void explain(const Options& options, const Chapter& chapter, const json& said) {
    if (!options.explain) return;
    options.json ? void(std::printf("%s\n", said.dump(1, ' ', false, json::error_handler_t::replace).c_str()))
                 : print_text(said, chapter.method_knob);
    std::fflush(stdout);
}

}  // namespace

Loading automatic_choice(const Options& options, Chapter& chapter) {
    if (!options.automatic) return {};
    if (chapter.subject)
        return {.before = [options, &chapter] { explain(options, chapter, chapter.subject->choose(*options.budget)); },
                .after = {}};
    const std::filesystem::path file = course_root() / "chapters" / chapter.name / "study.json";
    if (!std::filesystem::exists(file))
        throw InputError("chapter " + chapter.name + " has no study, from which --method auto would choose");
    const StudyPlan plan = read_study(parse_json(read_file(file), file.string()), chapter.all_knobs());
    return {.before = {}, .after = [options, &chapter, plan](Gpu& gpu) {
                const std::filesystem::path scene = chapter.scene.file.file;
                const std::string loaded = chapter.load_state();
                bool reload = false;
                json said;
                {
                    const ToggleScope judges(Exercises::ids(), true);
                    reload = chapter.load_state() != loaded;
                    if (reload) load_scene(chapter, gpu, scene);
                    const Picture picture{options.size, options.time_s, options.seed, {}};
                    said = choose_candidates(chapter, gpu, plan, {{*options.budget}, picture})[0];
                }
                if (reload) {
                    load_scene(chapter, gpu, scene);
                    set_knobs(chapter.all_knobs(), knobs_of(said["choice"], chapter.method_knob));
                }
                explain(options, chapter, said);
            }};
}

}  // namespace lightwalk
