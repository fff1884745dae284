#include "common/app/pictures.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "common/app/headless.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// Dependencies of a loaded scene. A scene file rewritten between two pictures counts as another; models and textures
// it names are kept while a list is drawn.
std::string load_key(const Options& options, const Chapter& chapter) {
    namespace fs = std::filesystem;
    std::string key = options.scene + " " + chapter.load_state();
    if (!options.shot.empty() || options.scene.empty()) return key;
    std::error_code error;
    const auto written = fs::last_write_time(options.scene, error).time_since_epoch().count();
    return fmt::format("{} {} {}", key, written, fs::file_size(options.scene, error));
}

// The previous picture's scene, and the key it was loaded with.
struct Loaded {
    std::string key;
    Scene scene;
};

void draw_one(Words words, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu,
              Loaded& before) {
    const std::unique_ptr<Chapter> chapter = make();
    chapter->name = name;
    words.insert(words.begin(), name);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    const auto options = read_options(static_cast<int>(arguments.size()), arguments.data(), *chapter);
    if (!options || options->screenshot.empty() || options->automatic)
        throw InputError("a picture of a list has a --screenshot, and no --method auto");
    std::string key = load_key(*options, *chapter);
    if (key == before.key) chapter->scene = std::move(before.scene);
    before = {};
    run_headless(*options, *chapter, gpu, {});
    before = {std::move(key), std::move(chapter->scene)};
}

}  // namespace

int draw_pictures(const Options& options, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu) {
    gpu = make_gpu(options);
    Loaded before;
    for (std::string line; std::getline(std::cin, line);) {
        json said{{"code", 0}, {"error", ""}};
        try {
            draw_one(json::parse(line).get<Words>(), name, make, gpu, before);
        } catch (const InputError& e) { said = {{"code", 2}, {"error", e.what()}}; } catch (const json::exception&) {
            said = {{"code", 2}, {"error", "a line is no list of words: " + line}};
        } catch (const std::exception& e) { said = {{"code", 1}, {"error", e.what()}}; }
        std::printf("%s\n", said.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace lightwalk
