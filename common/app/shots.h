// Named pictures of a chapter.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace lightwalk {

/// One of the list in tests/NN_name/shots.json.
struct Shot {
    std::string name, caption, scene;
    glm::uvec2 size{960, 540};
    float time_s = 0;
    int frames = 1;
    bool is_best = false;  ///< the file names it as "best"
    std::vector<std::pair<std::string, std::string>> set;
};

/// Throws InputError if the file is damaged; none if there is no file.
std::vector<Shot> read_shots(const std::string& chapter);

/// The same from a text; `file` stands for it in messages.
std::vector<Shot> parse_shots(const std::string& text, const std::string& file);

/// A chapter's shots, beginning with the one that shows it best: "best" in the file, without it the first.
std::vector<Shot> best_first(const std::string& chapter);

}  // namespace lightwalk
