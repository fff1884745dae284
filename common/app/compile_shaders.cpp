#include <cstdio>
#include <set>

#include "common/app/headless.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

constexpr size_t most_variants = 32;

Macros macros_of(const Chapter& chapter) {
    Macros macros;
    for (const KnobBase* knob : chapter.all_knobs()) knob->add_macros(macros);
    return macros;
}

void combine(const Chapter& chapter, std::span<KnobBase* const> knobs, std::vector<Macros>& result) {
    if (knobs.empty()) return result.push_back(macros_of(chapter));
    const std::string before = knobs[0]->text();
    for (const std::string& setting : knobs[0]->variants()) {
        knobs[0]->set(setting);
        combine(chapter, knobs.subspan(1), result);
    }
    knobs[0]->set(before);
}

// Product of the settings of all knobs that the shaders name; if too large, each method with one other knob.
std::vector<Macros> variants(const Chapter& chapter, const std::string& text, bool defaults_only) {
    if (defaults_only) return {macros_of(chapter)};
    std::vector<KnobBase*> named;
    size_t count = 1;
    std::set<std::string> macros;
    for (KnobBase* knob : chapter.all_knobs())
        if (!knob->variants().empty() && names_macro(text, knob->macro()) && macros.insert(knob->macro()).second) {
            count *= knob->variants().size();
            named.insert(knob->name == "method" ? named.begin() : named.end(), knob);
        }
    std::vector<Macros> result;
    if (count <= most_variants) {
        combine(chapter, named, result);
        return result;
    }
    for (size_t i = 1; i < named.size(); ++i) combine(chapter, std::array{named[0], named[i]}, result);
    return result;
}

int compile_pipeline(const Chapter& chapter, const Pipeline& pipeline, bool defaults_only, std::set<std::string>& seen,
                     std::set<std::filesystem::path>& files) {
    std::string text;
    for (const std::string& shader : pipeline.shaders())
        if (pipeline.compute.source.empty())
            text += flatten_bare(shader, pipeline.macros(), place_of(pipeline.where)).text;
    int modules = 0;
    for (const Macros& macros : variants(chapter, text, defaults_only)) {
        const std::vector<FlatShader> flat = flatten_stages(pipeline, macros);
        std::string all;
        for (const FlatShader& shader : flat) {
            all += shader.text;
            files.insert(shader.files.begin(), shader.files.end());
        }
        if (!seen.insert(std::move(all)).second) continue;
        CompiledStages stages = compile_stages(pipeline, flat);
        assign_bindings(stages);
        for (size_t i = 0; i < stages.spirv.size(); ++i, ++modules)
            if (const std::string why = validate_spirv(stages.spirv[i]); !why.empty())
                throw ShaderError("{}: spirv-val: {}", stages.names[i], why);
    }
    return modules;
}

}  // namespace

int compile_all_shaders(Chapter& chapter, const std::string& stamp, bool all) {
    // Defaults suffice for starters and for single swaps of an exercise: a swap can only break an interface.
    std::vector<std::string> states{"solution", "exercise"};
    for (const std::string& id : Exercises::ids()) {
        if (!all || id.substr(0, 2) != chapter.name.substr(0, 2)) continue;
        states.push_back(fmt::format("solution,{}=exercise", id));
        states.push_back(fmt::format("exercise,{}=solution", id));
    }
    int modules = 0;
    std::set<std::string> seen;
    std::set<std::filesystem::path> files;
    for (const std::string& state : states) {
        Exercises::use(state);
        for (const Pipeline* pipeline : Pipeline::all())
            modules += compile_pipeline(chapter, *pipeline, !all || state != "solution", seen, files);
    }
    std::printf("%s: %d different shader modules compiled and valid in %zu toggle states\n", chapter.name.c_str(),
                modules, states.size());
    std::string rule = stamp + ":";
    for (const auto& file : files) rule += " \\\n " + file.string();
    write_file(stamp + ".d", rule + "\n");
    write_file(stamp, "");
    return 0;
}

}  // namespace lightwalk
