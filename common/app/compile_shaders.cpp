#include <cstdio>
#include <set>

#include "common/app/options.h"
#include "common/course/exercise.h"
#include "common/error.h"

namespace lightwalk {
namespace {

// The macros' settings that give different text: the product over the knobs the shaders name.
std::vector<Defines> variants(const Chapter& chapter, const std::string& text, bool defaults_only) {
    std::vector<Defines> result{Defines{}};
    for (KnobBase* knob : chapter.knobs) {
        const auto macros = knob->macros();
        if (macros.empty()) continue;
        const bool named = text.find(macros[0].first) != text.npos;
        const std::string before = knob->text();
        std::vector<Defines> next;
        for (const std::string& setting : defaults_only ? std::vector{before} : knob->variants()) {
            knob->set(setting);
            for (Defines defines : result) {
                for (const auto& [name, value] : knob->macros()) defines[name] = value;
                next.push_back(std::move(defines));
            }
            if (!named) break;
        }
        knob->set(before);
        result = std::move(next);
    }
    return result;
}

// Compiles what no earlier state or variant has compiled already.
int compile_pipeline(const Chapter& chapter, const Pipeline& pipeline, bool defaults_only,
                     std::set<std::string>& seen) {
    std::string text;
    for (const std::string& shader : pipeline.shaders())
        if (pipeline.compute.source.empty()) text += flatten(shader, {}).text;
    int modules = 0;
    for (const Defines& defines : variants(chapter, text, defaults_only)) {
        const std::vector<FlatShader> flat = flatten_stages(pipeline, defines);
        std::string all;
        for (const FlatShader& shader : flat) all += shader.text;
        if (!seen.insert(std::move(all)).second) continue;
        CompiledStages stages = compile_stages(pipeline, flat);
        assign_bindings(stages);
        for (size_t i = 0; i < stages.spirv.size(); ++i, ++modules)
            if (const std::string why = validate_spirv(stages.spirv[i]); !why.empty())
                throw ShaderError(stages.names[i] + ": spirv-val: " + why);
    }
    return modules;
}

}  // namespace

int compile_all_shaders(Chapter& chapter) {
    // Every variant with all references and with all starters; one exercise swapped at a time with default knobs, for
    // what swapping can break is the interface between the two.
    std::vector<std::string> states{"solution", "exercise"};
    for (const std::string& id : Exercises::ids()) {
        if (id.substr(0, 2) > chapter.name.substr(0, 2)) continue;
        states.push_back("solution," + id + "=exercise");
        states.push_back("exercise," + id + "=solution");
    }
    int modules = 0;
    std::set<std::string> seen;
    for (const std::string& state : states) {
        Exercises::use(state);
        for (const Pipeline* pipeline : Pipeline::all())
            modules += compile_pipeline(chapter, *pipeline, state.find(',') != state.npos, seen);
    }
    std::printf("%s: %d different shader modules compiled and valid in %zu toggle states\n", chapter.name.c_str(),
                modules, states.size());
    return 0;
}

}  // namespace lightwalk
