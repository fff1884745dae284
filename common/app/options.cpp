#include "common/app/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

glm::uvec2 parse_size(const std::string& text) {
    glm::uvec2 size(0);
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = cross ? std::from_chars(width.ptr + 1, end, size.y) : width;
    if (!cross || height.ec != std::errc() || height.ptr != end || size.x < 1 || size.y < 1 || size.x > 16384 ||
        size.y > 16384)
        throw InputError("--size {}: expected WIDTHxHEIGHT, each from 1 to 16384, such as 960x540", text);
    if (int64_t{size.x} * size.y > max_image_pixels)
        throw InputError("--size {}: too large, a picture has at most {} Mi pixels", text, max_image_pixels >> 20);
    return size;
}

// "auto" for the method leaves the choice to the need rule.
void set_knob(Options& options, Chapter& chapter, const std::string& name, const std::string& value) {
    const KnobList knobs = chapter.all_knobs();
    KnobBase& knob = find_knob(knobs, name == "method" ? chapter.method_knob : name);
    if (value == "auto" && &knob == &find_knob(knobs, chapter.method_knob)) {
        options.automatic = true;
        return;
    }
    knob.set(value);
    knob.pinned = true;
}

void apply_shot(Options& options, Chapter& chapter) {
    std::string known;
    for (const Shot& shot : read_shots(chapter.name)) {
        known += (known.empty() ? "" : ", ") + shot.name;
        if (shot.name != options.shot) continue;
        if (options.scene.empty()) options.scene = shot.scene;
        if (!options.size_given) options.size = shot.size;
        if (!options.time_given) options.time_s = shot.time_s;
        if (!options.frames_given) options.frames = shot.frames;
        for (const auto& [name, value] : shot.set) set_knob(options, chapter, name, value);
        return;
    }
    throw InputError("unknown shot '{}'; {} has: {}", options.shot, chapter.name, known);
}

}  // namespace

std::optional<Options> read_options(int argc, char** argv, Chapter& chapter) {
    Options o;
    std::string size, validate = "off", method;
    CLI::App app("Lightwalk, chapter " + chapter.name);
    app.add_option("--scene", o.scene, "a scene file or any model file; default: " + chapter.default_scene());
    app.add_option("--use", o.use, "solution (default), exercise, or a list such as exercise,02.phong=solution");
    app.add_option("--set", o.set, "NAME=VALUE sets a knob; may be repeated")->allow_extra_args(false);
    app.add_option("--budget", o.budget, "with --method auto: the greatest error allowed, mean FLIP for pictures");
    app.add_option("--shot", o.shot, "a named shot of the chapter: --list shots");
    app.add_option("--size", size, "WIDTHxHEIGHT in pixels; default 960x540");
    app.add_option("--time", o.time_given, "seconds on the chapter's clock")->check(CLI::Range(-1e6, 1e6));
    auto* frames =
        app.add_option("--frames", o.frames, "frames to render; the last one is kept")->check(CLI::Range(1, 100000));
    app.add_option("--look", o.look,
                   "a pass whose output is shown in place of the picture: its name, or 'pass: image'");
    app.add_option("--screenshot", o.screenshot, "render without a window, write a PNG, exit");
    app.add_option("--timings", o.timings, "GPU milliseconds per pass, as JSON, to this file");
    app.add_option("--study", o.study, "run the chapter's study, as JSON, to this file");
    app.add_flag("--explain", o.explain, "with --method auto: print what was measured, the rule and the choice");
    app.add_option("--list", o.list, "print and exit")
        ->check(CLI::IsMember({"knobs", "shots", "exercises", "devices"}));
    app.add_flag("--json", o.json, "lists and reports as JSON");
    app.add_option("--device", o.device, "a part of a device's name, or hardware's type; --list devices");
    app.add_option("--validate", validate, "Vulkan validation, core and synchronisation; a message is a failure")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_option("--seed", o.seed, "seed for what is random");
    app.add_option("--compile-shaders", o.compile_shaders,
                   "compile and validate all shaders in all variants; for the build")
        ->type_name("STAMP");
    app.add_flag("--default-variants", o.default_variants, "with --compile-shaders: the default knobs alone");
    app.add_flag("--pictures", o.pictures,
                 "draw what each line of standard input asks for, words as a JSON list; for tests");
    std::map<std::string, std::string> by_knob, by_command;
    const KnobList knobs = chapter.all_knobs();
    for (const KnobBase* knob : knobs) {
        const std::string path = knob->path();
        std::string names = "--" + path;
        if (has_short_name(knobs, *knob)) names += ",--" + knob->name;
        app.add_option(names, by_knob[path], knob->help)->group("Knobs");
    }
    const bool own_method = chapter.method_knob != "method";
    if (own_method) app.add_option("--method", method, "the same as --" + chapter.method_knob);
    for (const Command& command : chapter.commands)
        app.add_option("--" + command.flag, by_command[command.flag], command.help)->type_name(command.argument);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::printf("%s", app.help().c_str());
        return std::nullopt;
    } catch (const CLI::ParseError& e) { throw InputError("{}; --help lists what there is", e.what()); }
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results())
            if (value.empty())
                throw InputError("{} is given an empty text; --help says what it takes", option->get_name());
    // CLI11's ranges let a NaN through: it is neither below nor above them.
    if (o.budget && !(*o.budget >= 0)) throw InputError("--budget: the greatest error allowed is 0 or more");
    if (o.time_given && std::isnan(*o.time_given)) throw InputError("--time nan: expected seconds from -1e6 to 1e6");
    o.validate = validate == "on";
    o.frames_given = !frames->empty();
    o.size_given = !size.empty();
    if (o.size_given) o.size = parse_size(size);
    if (o.time_given) o.time_s = *o.time_given;
    Exercises::use(o.use);
    if (!o.shot.empty()) apply_shot(o, chapter);
    for (const std::string& item : o.set) {
        const size_t equals = item.find('=');
        if (equals == item.npos) throw InputError("--set {}: expected NAME=VALUE", item);
        set_knob(o, chapter, item.substr(0, equals), item.substr(equals + 1));
    }
    for (const auto& [name, value] : by_knob)
        if (!app.get_option("--" + name)->empty()) set_knob(o, chapter, name, value);
    if (!method.empty()) set_knob(o, chapter, chapter.method_knob, method);
    if (o.automatic && !o.budget) throw InputError("--method auto needs --budget E, the greatest error allowed");
    if (o.explain && !o.automatic) throw InputError("--explain goes with --method auto");
    for (const Command& command : chapter.commands)
        if (!app.get_option("--" + command.flag)->empty())
            o.command = [command, argument = by_command[command.flag], json = o.json] {
                return command.run(argument, json);
            };
    return o;
}

}  // namespace lightwalk
