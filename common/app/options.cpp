#include "common/app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/names.h"
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
    std::vector<std::string> known;
    for (const Shot& shot : read_shots(chapter.name)) {
        known.push_back(shot.name);
        if (shot.name != options.shot) continue;
        if (options.scene.empty()) options.scene = shot.scene;
        if (!options.size_given) options.size = shot.size;
        if (!options.time_given) options.time_s = shot.time_s;
        if (!options.frames_given) options.frames = shot.frames;
        for (const auto& [name, value] : shot.set) set_knob(options, chapter, name, value);
        return;
    }
    throw unknown_name("shot", options.shot, known, "--list shots lists all");
}

void read_list(const std::vector<std::string>& words, Options& o) {
    if (words.empty()) return;
    const std::vector<std::string> known = {"knobs", "shots", "exercises", "devices", "model"};
    if (std::find(known.begin(), known.end(), words[0]) == known.end())
        throw unknown_name("list", words[0], known, "--help lists all");
    if (words.size() == 1 && words[0] == "model") throw InputError("--list model FILE: a model file is missing");
    if (words.size() == 2 && words[0] != "model") throw InputError("--list {}: '{}' is too much", words[0], words[1]);
    o.list = words[0];
    if (words.size() == 2) o.list_file = words[1];
}

// Default shot of a window without other arguments: the best one.
std::string opening_shot(const Options& options, const CLI::App& app, const Chapter& chapter) {
    const auto other = [](const CLI::Option* one) {
        return !one->empty() && one->get_name() != "--device" && one->get_name() != "--validate" &&
               one->get_name() != "--size" && one->get_name() != "--device-paths" && one->get_name() != "--use";
    };
    const std::vector<const CLI::Option*> given = app.get_options();
    if (options.headless() || std::any_of(given.begin(), given.end(), other)) return {};
    const std::vector<Shot> shots = best_first(chapter.name);
    return !shots.empty() && shots.front().is_best && shots.front().time_s == 0 ? shots.front().name : std::string();
}

void add_knobs(CLI::App& app, const KnobList& knobs, std::map<std::string, std::string>& values) {
    const auto add = [&](const KnobBase& knob, const std::string& group) {
        std::string names = "--" + knob.path();
        if (has_short_name(knobs, knob)) names += ",--" + knob.name;
        if (values.contains(knob.path()))
            throw Failure("two knobs are called '{}'; give one of their modules another name", knob.path());
        app.add_option(names, values[knob.path()], knob.help)->type_name(knob.usage())->group(group);
    };
    for (const KnobBase* knob : knobs)
        if (knob->owner.path().empty()) add(*knob, "Knobs of the chapter");
    for (const KnobBase* knob : knobs)
        if (!knob->owner.path().empty()) add(*knob, "Knobs of '" + knob->owner.path() + "'");
}

InputError unrecognised(const CLI::App& app) {
    std::vector<std::string> known, left = app.remaining();
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    const auto dashed =
        std::find_if(left.begin(), left.end(), [](const auto& word) { return word.rfind("-", 0) == 0; });
    if (dashed == left.end())
        return InputError("unrecognised argument '{}': options begin with --{}; --help lists all", left.front(),
                          left.front().ends_with(".json") ? ", a scene is --scene FILE" : "");
    return unknown_name("option", dashed->substr(0, dashed->find('=')), known, "--help lists all");
}

}  // namespace

std::optional<Options> read_options(int argc, char** argv, Chapter& chapter) {
    Options o;
    std::string size, validate = "off", refine = "on", paths, method;
    std::vector<std::string> list;
    CLI::App app("Lightwalk, chapter " + chapter.name);
    app.add_option("--scene", o.scene, "Scene file or model file (" + chapter.default_scene() + ")")->type_name("FILE");
    app.add_option("--use", o.use,
                   "Whose exercises run: solution (default), exercise, or a list such as exercise,02.phong=solution")
        ->type_name("WHICH");
    app.add_option("--set", o.set, "Sets a knob; repeatable")->allow_extra_args(false)->type_name("NAME=VALUE");
    app.add_option("--budget", o.budget, "Greatest error allowed with --method auto; mean FLIP for pictures")
        ->type_name("E");
    app.add_option("--shot", o.shot, "Named picture of the chapter; --list shots names them")->type_name("NAME");
    app.add_option("--size", size, "Picture size in pixels (960x540)")->type_name("WxH");
    app.add_option("--time", o.time_given, "Time on the chapter's clock, from -1e6 to 1e6 (0)")
        ->check(CLI::Range(-1e6, 1e6).description(""))
        ->type_name("SECONDS");
    auto* frames =
        app.add_option("--frames", o.frames, "Number of frames to draw, from 1 to 100000; the last is kept (1)")
            ->check(CLI::Range(1, 100000).description(""))
            ->type_name("N");
    app.add_option("--camera-of-file", o.camera_of_file,
                   "Which camera of a model file to look through, from 1 on, with the file's lights")
        ->check(CLI::Range(1, 1000000).description(""))
        ->type_name("N");
    app.add_option("--look", o.look, "Pass whose output is shown instead of the picture: its name, or 'pass: image'")
        ->type_name("PASS");
    app.add_option("--screenshot", o.screenshot, "Draw without a window, write a PNG, exit")->type_name("FILE");
    app.add_option("--capture", o.capture, "Draw without a window, write the last frame for RenderDoc (.rdc), exit")
        ->type_name("FILE");
    app.add_option("--timings", o.timings, "Write GPU milliseconds per pass as JSON, exit")->type_name("FILE");
    app.add_option("--study", o.study, "Run the chapter's study, write it as JSON, exit")->type_name("FILE");
    app.add_option("--study-file", o.study_file, "With --study: another study than the chapter's")->type_name("FILE");
    app.add_option("--study-rounds", o.study_rounds, "With --study: how often each method is timed")->type_name("N");
    app.add_flag("--explain", o.explain, "With --method auto: print the measurements, the rule and the choice");
    app.add_option("--list", list, "Print a list, or what was read of a model file and what was left out, exit")
        ->expected(1, 2)
        ->type_name("{knobs,shots,exercises,devices,model FILE}");
    app.add_flag("--json", o.json, "Print lists and reports as JSON");
    app.add_option("--device", o.device, "Part of a device's name, or 'hardware'; --list devices names them")
        ->type_name("NAME");
    app.add_option("--validate", validate, "Vulkan core and synchronisation validation; a message is a failure (off)")
        ->check(CLI::IsMember({"on", "off"}).description(""))
        ->type_name("{on,off}");
    app.add_option("--device-paths", paths,
                   "For tests: code paths of a software or of a hardware device (the device's own)")
        ->check(CLI::IsMember({"software", "hardware"}).description(""))
        ->type_name("{software,hardware}");
    app.add_option("--seed", o.seed, "Seed of everything random (0)")->type_name("N");
    app.add_option("--compile-shaders", o.compile_shaders, "For the build: compile and validate every shader variant")
        ->type_name("STAMP");
    app.add_flag("--default-variants", o.default_variants, "with --compile-shaders: the default knobs alone");
    app.add_flag("--pictures", o.pictures,
                 "For tests and ./course serve: draw what each line of standard input asks for");
    app.add_option("--refine", refine, "Whether a window's picture at rest gathers samples (on)")
        ->check(CLI::IsMember({"on", "off"}).description(""))
        ->type_name("{on,off}");
    app.add_option("--events", o.events, "For tests: log a window's events to standard output")
        ->check(CLI::IsMember({"on"}).description(""))
        ->type_name("{on}");
    app.add_option("--shaders-into", o.shaders_into, "For ./course grade: write each compiled shader to this folder")
        ->type_name("FOLDER");
    app.add_option("--shaders-from", o.shaders_from, "For ./course grade: read compiled shaders from this folder alone")
        ->type_name("FOLDER");
    std::map<std::string, std::string> by_knob, by_command;
    const KnobList knobs = chapter.all_knobs();
    check_macros(knobs);
    add_knobs(app, knobs, by_knob);
    const bool own_method = chapter.method_knob != "method";
    if (own_method) app.add_option("--method", method, "Same as --" + chapter.method_knob)->type_name("NAME");
    for (const Command& command : chapter.commands)
        app.add_option("--" + command.flag, by_command[command.flag], command.help)->type_name(command.argument);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::printf("%s", app.help().c_str());
        return std::nullopt;
    } catch (const CLI::ExtrasError&) { throw unrecognised(app); } catch (const CLI::ArgumentMismatch& e) {
        const std::string_view said = e.what();
        throw InputError("{}: expected one value; --help says which", said.substr(0, said.find(':')));
    } catch (const CLI::ParseError& e) { throw InputError("{}; --help lists all options", e.what()); }
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results())
            if (value.empty())
                throw InputError("{}: the value is empty; --help says what it takes", option->get_name());
    // CLI11's range checks accept NaN.
    if (o.budget && !(*o.budget >= 0)) throw InputError("--budget: the greatest error allowed is 0 or more");
    if (o.time_given && std::isnan(*o.time_given)) throw InputError("--time nan: expected seconds from -1e6 to 1e6");
    const std::filesystem::path picture = o.screenshot;
    if (picture.has_extension() && picture.extension() != ".png")
        throw InputError("--screenshot {}: a PNG is written; expected a name in .png", o.screenshot);
    o.validate = validate == "on";
    o.refine = refine == "on";
    if (!paths.empty()) o.software_paths = paths == "software";
    chapter.camera_of_file = o.camera_of_file;
    read_list(list, o);
    o.frames_given = !frames->empty();
    o.size_given = !size.empty();
    if (o.size_given) o.size = parse_size(size);
    if (o.time_given) o.time_s = *o.time_given;
    Exercises::use("solution");  // resets toggles: one process may parse options of many pictures
    Exercises::use(o.use);
    const std::vector<std::string> ids = Exercises::ids();
    if (app.count("--use") > 0 && ("," + o.use).find(",solution") != std::string::npos && !ids.empty() &&
        std::ranges::none_of(ids, &Exercises::has_solution))
        fmt::print(stderr, "--use solution: this copy of the course has no solutions; your exercises are used\n");
    if (o.shot.empty()) o.shot = opening_shot(o, app, chapter);
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
            o.command = [command, argument = by_command[command.flag]](const Options& options,
                                                                       std::unique_ptr<Gpu>& gpu) {
                return command.run(argument, options, gpu);
            };
    return o;
}

}  // namespace lightwalk
