// Named shots of a chapter.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace lightwalk {

/// Entry of tests/NN_name/shots.json.
struct Shot {
    std::string name, caption, scene;
    glm::uvec2 size{960, 540};
    float time_s = 0;
    int frames = 1;
    bool is_best = false;
    std::vector<std::pair<std::string, std::string>> set;
};

/// Empty if the file is missing. Throws InputError if it is invalid.
std::vector<Shot> read_shots(const std::string& chapter);

/// Parses JSON text; `file` is the name in error messages.
std::vector<Shot> parse_shots(const std::string& text, const std::string& file);

/// Shots with the best one first: the file's "best", else its first.
std::vector<Shot> best_first(const std::string& chapter);

}  // namespace lightwalk
