// Command line of chapter executables.
#pragma once
#include <optional>

#include "common/app/chapter.h"

namespace lightwalk {

struct Options {
    std::string scene, use = "solution", shot, look, screenshot, timings, study, capture, list, list_file, device,
                       compile_shaders;
    std::vector<std::string> set;
    glm::uvec2 size{960, 540};
    bool size_given = false;
    float time_s = 0;
    std::optional<float> time_given;
    int frames = 1, camera_of_file = 0;
    bool frames_given = false, json = false, validate = false, explain = false;
    std::optional<bool> software_paths;  ///< forces Device::software_paths
    bool default_variants = false;       ///< with compile_shaders: default knobs only
    bool pictures = false;               ///< pictures requested on standard input
    bool refine = true;                  ///< a still view in a window accumulates samples
    std::string events;                  ///< event log of the window: "on"; empty: none
    std::string study_file;
    std::optional<int> study_rounds;
    std::string shaders_into, shaders_from;  ///< folders of common/gpu/sealed.h
    bool automatic = false;                  ///< --method auto: chosen by the need rule
    std::optional<double> budget;
    unsigned seed = 0;
    std::function<int(const Options&, std::unique_ptr<Gpu>&)> command;  ///< chapter-specific command to run instead
    bool headless() const { return !screenshot.empty() || !timings.empty() || !study.empty() || !capture.empty(); }
};

/// Parses the command line and applies it to the chapter. Empty after printing help. Throws InputError.
std::optional<Options> read_options(int argc, char** argv, Chapter& chapter);

}  // namespace lightwalk
