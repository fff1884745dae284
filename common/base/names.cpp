#include "common/base/names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lightwalk {
namespace {

constexpr size_t compared_bytes = 64;

std::string_view last_part(std::string_view name) { return name.substr(name.rfind('.') + 1); }

// Twice the edit distance. A wrong module costs less than a wrong last part; containing the typed text counts as near.
size_t badness(std::string_view wrong, std::string_view name) {
    const size_t whole = 2 * edit_distance(wrong, name);
    const size_t parts = 2 * edit_distance(last_part(wrong), last_part(name)) + (wrong.find('.') == wrong.npos ? 1 : 3);
    const bool holds = wrong.size() > 2 && name.find(wrong) != name.npos;
    return std::min({whole, parts, holds ? size_t{2} : whole});
}

}  // namespace

std::string lowercase(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

bool has_words(std::string_view text, std::string_view words) {
    const std::string own = lowercase(text), wanted = lowercase(words);
    for (size_t at = 0, end = 0; at < wanted.size(); at = end + 1) {
        end = std::min(wanted.find(' ', at), wanted.size());
        if (own.find(wanted.substr(at, end - at)) == own.npos) return false;
    }
    return true;
}

size_t edit_distance(std::string_view a, std::string_view b) {
    a = a.substr(0, compared_bytes);
    b = b.substr(0, compared_bytes);
    const auto at = [](std::string_view text, size_t i) { return std::tolower(static_cast<unsigned char>(text[i])); };
    std::array<std::array<size_t, compared_bytes + 1>, compared_bytes + 1> steps{};
    for (size_t i = 0; i <= a.size(); ++i) steps[i][0] = i;
    for (size_t j = 0; j <= b.size(); ++j) steps[0][j] = j;
    for (size_t i = 1; i <= a.size(); ++i)
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = at(a, i - 1) == at(b, j - 1);
            size_t& step = steps[i][j];
            step = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1, steps[i - 1][j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && at(a, i - 1) == at(b, j - 2) && at(a, i - 2) == at(b, j - 1))
                step = std::min(step, steps[i - 2][j - 2] + 1);
        }
    return steps[a.size()][b.size()];
}

std::vector<std::string> nearest_names(std::string_view wrong, const std::vector<std::string>& names, size_t most) {
    std::vector<std::pair<size_t, std::string>> ranked;
    for (const std::string& name : names) ranked.emplace_back(badness(wrong, name), name);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> nearest;
    for (size_t i = 0; i < std::min(most, ranked.size()); ++i) nearest.push_back(ranked[i].second);
    return nearest;
}

InputError unknown_name(std::string_view kind, std::string_view wrong, const std::vector<std::string>& names,
                        std::string_view how) {
    std::string nearest;
    for (const std::string& name : nearest_names(wrong, names)) nearest += (nearest.empty() ? "" : " and ") + name;
    return InputError(
        "unknown {} '{}'; {}{}", kind, wrong,
        nearest.empty() ? "there is none" : (names.size() > 1 ? "the nearest are " : "the only one is ") + nearest,
        how.empty() ? "" : fmt::format("; {}", how));
}

}  // namespace lightwalk
