// Methods that the need rule has chosen, or is to choose, while the window is open.
#pragma once
#include <map>
#include <set>
#include <string>

namespace lightwalk {

/// Knobs by their paths.
struct AutoChoices {
    struct Chosen {
        std::string method;  ///< it stays chosen as long as the knob has this value
        std::string line;    ///< which and why, or why not
    };
    std::set<std::string> offered;  ///< the ones compared by a study
    std::set<std::string> without;  ///< methods that none compares
    std::map<std::string, Chosen> chosen;
    float budget = 0.01f;  ///< greatest mean FLIP allowed
    std::string wanted;    ///< asked for by a click and not measured yet; empty: none
    int asked_at = 0;      ///< frames that were drawn before

    bool holds(const std::string& path, const std::string& method) const {
        const auto found = chosen.find(path);
        return found != chosen.end() && found->second.method == method;
    }
};

}  // namespace lightwalk
