// The command line every chapter executable takes.
#pragma once
#include <optional>

#include "common/app/chapter.h"

namespace lightwalk {

struct Options {
    std::string scene, use = "solution", shot, look, screenshot, timings, study, capture, list, list_file, device,
                       compile_shaders;
    std::vector<std::string> set;  ///< NAME=VALUE
    glm::uvec2 size{960, 540};
    bool size_given = false;
    float time_s = 0;
    std::optional<float> time_given;
    int frames = 1, camera_of_file = 0;
    bool frames_given = false, json = false, validate = false, explain = false;
    std::optional<bool> software_paths;  ///< forces Device::software_paths
    bool default_variants = false;       ///< for compile_shaders
    bool pictures = false;               ///< standard input says which
    bool refine = true;                  ///< a window's picture at rest gathers samples
    std::string events;                  ///< log of a window's events: "on", "layout"; default: none
    std::string study_file;              ///< default: the chapter's own
    std::optional<int> study_rounds;
    std::string shaders_into, shaders_from;  ///< common/gpu/sealed.h
    bool automatic = false;                  ///< --method auto: the need rule chooses
    std::optional<double> budget;
    unsigned seed = 0;
    std::function<int(const Options&, std::unique_ptr<Gpu>&)> command;  ///< a chapter's own, where one was asked for
    bool headless() const { return !screenshot.empty() || !timings.empty() || !study.empty() || !capture.empty(); }
};

/// Reads the command line and applies shot, knobs and toggles to the chapter. Throws InputError. Where only help was
/// asked for, prints it and returns nothing.
std::optional<Options> read_options(int argc, char** argv, Chapter& chapter);

}  // namespace lightwalk
