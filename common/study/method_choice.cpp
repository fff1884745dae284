
#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/study/need.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Of all chapters, by the kind of the module.
const std::map<std::string, fs::path>& studies() {
    static const std::map<std::string, fs::path> all = [] {
        std::map<std::string, fs::path> found;
        std::error_code error;
        std::vector<fs::path> files;  // study.json, and of further modules study_NAME.json
        for (const auto& folder : fs::directory_iterator(course_root() / "chapters", error))
            for (const auto& file : fs::directory_iterator(folder.path(), error))
                if (file.path().extension() == ".json" && file.path().stem().string().starts_with("study"))
                    files.push_back(file.path());
        std::sort(files.begin(), files.end());
        for (const fs::path& file : files) {
            const json study = json::parse(read_file(file), nullptr, false);
            if (study.is_object() && study.contains("module") && study["module"].is_string())
                found.emplace(study["module"].get<std::string>(), file);
        }
        return found;
    }();
    return all;
}

bool is_own_method(const Chapter& chapter, const KnobBase& knob) {
    try {
        return &find_knob(chapter.all_knobs(), chapter.method_knob) == &knob;
    } catch (const InputError&) { return false; }  // it has none
}

StudyPlan plan_for(const Chapter& chapter, const KnobBase& method, const fs::path& file) {
    const JsonWithLines source = parse_json(read_file(file), file.string());
    const KnobList& knobs = chapter.all_knobs();
    if (is_own_method(chapter, method)) return read_study(source, knobs);
    try {
        return read_study_of(method, source, knobs);
    } catch (const InputError&) {
        throw InputError("{}: its reference, {}, exists in chapter {} only", method.path(),
                         source.root.at("truth").at("set").dump(), file.parent_path().filename().string().substr(0, 2));
    }
}

std::string words_of(const json& choice, const KnobBase& method) {
    std::string words = choice.at("method"), others;
    for (const auto& [name, value] : choice.at("knobs").items()) {
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        if (name == method.path())
            words = text;
        else
            others += ", " + name + " " + text;
    }
    return words + others;
}

std::string line_of(const json& said, const KnobBase& method, glm::uvec2 size) {
    const json &choice = said["choice"], &all = said["candidates"];
    const std::string words = words_of(choice, method);
    const double error = choice["error"].is_number() ? choice["error"].get<double>() : 0.0;
    const std::string measured =
        fmt::format("FLIP {:.2g}, {:.3g} ms at {}×{}", error, choice["time_ms"].get<double>(), size.x, size.y);
    const double budget = said["budget"];
    if (said["none_would_do"] == true)
        return fmt::format("{}: none of {} is within {:g}; the most accurate is {} ({})", method.path(), all.size(),
                           budget, words, measured);
    const bool alike = std::all_of(all.begin(), all.end(), [](const json& c) { return c["error"] == 0.0; });
    return alike ? fmt::format("{}: {} is the fastest; all {} draw this picture alike ({})", method.path(), words,
                               all.size(), measured)
                 : fmt::format("{}: {} is the fastest within {:g}; {} were measured ({})", method.path(), words, budget,
                               all.size(), measured);
}

}  // namespace

fs::path study_of(const Chapter& chapter, const KnobBase& knob) {
    if (is_own_method(chapter, knob)) {
        const fs::path own = course_root() / "chapters" / chapter.name / "study.json";
        return file_exists(own) ? own : fs::path();
    }
    const auto found = knob.name == "method" ? studies().find(knob.owner.kind()) : studies().end();
    return found == studies().end() ? fs::path() : found->second;
}

std::string choose_method(Chapter& chapter, Gpu& gpu, KnobBase& method, double budget, const Picture& picture,
                          const std::function<void()>& between) {
    const fs::path file = study_of(chapter, method);
    if (file.empty()) throw InputError("{}: no study compares its methods", method.path());
    if (chapter.subject && is_own_method(chapter, method))
        throw InputError("{}: measured while a scene is loaded; start with --method auto --budget {:g}", method.path(),
                         budget);
    const StudyPlan plan = plan_for(chapter, method, file);
    if (plan.error_metric != "flip_mean")
        throw InputError("{}: its study measures {}, not the picture", method.path(), plan.error_metric);
    const bool pinned = std::exchange(method.pinned, false);
    const auto pin_again = [&] { method.pinned = pinned; };
    try {
        const json said =
            choose_candidates(chapter, gpu, plan, {.budgets = {budget}, .picture = picture, .between = between})[0];
        pin_again();
        return line_of(said, method, picture.size);
    } catch (...) {
        pin_again();
        throw;
    }
}

}  // namespace lightwalk
