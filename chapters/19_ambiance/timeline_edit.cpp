#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "19_ambiance/timeline.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

using nlohmann::json;

/// Where a value stands in a text.
struct Piece {
    size_t begin = 0, end = 0;  ///< end: behind it
    std::string name;           ///< of a member of an object
};

// Places in a text that is known to be JSON: only where things begin and end has to be found out.
class Places {
  public:
    explicit Places(const std::string& text) : text_(text) {}

    /// The members of an object, or the entries of a list.
    std::vector<Piece> inside(const Piece& outer) const {
        std::vector<Piece> all;
        size_t at = skip_blank(outer.begin + 1);
        while (at + 1 < outer.end) {
            Piece piece;
            if (text_[outer.begin] == '{') {
                const size_t end = value_end(at);
                piece.name = json::parse(text_.substr(at, end - at)).get<std::string>();
                at = skip_blank(skip_blank(end) + 1);  // the colon
            }
            piece.begin = at;
            piece.end = value_end(at);
            all.push_back(piece);
            at = skip_blank(piece.end);
            if (text_[at] == ',') at = skip_blank(at + 1);
        }
        return all;
    }
    Piece whole() const {
        const size_t begin = skip_blank(0);
        return {begin, value_end(begin), ""};
    }
    const Piece* member(const std::vector<Piece>& members, const std::string& name) const {
        for (const Piece& one : members)
            if (one.name == name) return &one;
        return nullptr;
    }
    /// The text between the beginning of a piece's line and the piece.
    std::string before_on_line(const Piece& piece) const {
        const size_t line = text_.rfind('\n', piece.begin);
        const size_t from = line == std::string::npos ? 0 : line + 1;
        return text_.substr(from, piece.begin - from);
    }

  private:
    size_t skip_blank(size_t at) const { return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size()); }
    size_t value_end(size_t at) const {
        if (text_[at] == '"') return string_end(at);
        if (text_[at] != '{' && text_[at] != '[') return std::min(text_.find_first_of(",]} \t\r\n", at), text_.size());
        int depth = 0;
        for (; at < text_.size(); ++at) {
            const char c = text_[at];
            if (c == '"') at = string_end(at) - 1;
            if (c == '{' || c == '[') ++depth;
            if ((c == '}' || c == ']') && --depth == 0) return at + 1;
        }
        return at;
    }
    size_t string_end(size_t at) const {
        for (++at; text_[at] != '"'; ++at)
            if (text_[at] == '\\') ++at;
        return at + 1;
    }
    const std::string& text_;
};

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r") == std::string::npos; }

/// The scene's members, and its camera's keys where it has some.
struct SceneText {
    std::vector<Piece> members, keys;
    SceneText(const Places& places, size_t scene) {
        const std::vector<Piece> film = places.inside(places.whole());
        members = places.inside(places.inside(*places.member(film, "scenes")).at(scene));
        const Piece* camera = places.member(members, "camera");
        if (!camera) return;
        const std::vector<Piece> path = places.inside(*camera);
        keys = places.inside(*places.member(path, "keys"));
    }
};

double time_of(const std::string& text, const Piece& key) {
    return json::parse(text.substr(key.begin, key.end - key.begin)).at("time_s").get<double>();
}

/// The key within near_s of a time that is nearest to it.
const Piece* key_near(const std::string& text, const std::vector<Piece>& keys, double time_s, double near_s) {
    const Piece* nearest = nullptr;
    double least = near_s;
    for (const Piece& key : keys)
        if (const double off = std::abs(time_of(text, key) - time_s); off <= least) {
            nearest = &key;
            least = off;
        }
    return nearest;
}

std::string number(double value) {
    const double rounded = std::round(value * 1000) / 1000;
    return fmt::format("{:.10g}", rounded == 0 ? 0.0 : rounded);  // and no -0
}

std::string list(glm::dvec3 v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }

}  // namespace

std::string key_text(const CameraKey& key) {
    std::string text = fmt::format("{{\"time_s\": {}, \"position\": {}, \"target\": {}", number(key.time_s),
                                   list(key.position), list(key.target));
    if (glm::distance(glm::normalize(key.up), glm::dvec3(0, 1, 0)) > 1e-3)
        text += ", \"up\": " + list(glm::normalize(key.up));
    if (key.fov_deg > 0) text += ", \"fov_deg\": " + number(key.fov_deg);
    return text + "}";
}

std::string with_key(const std::string& text, size_t scene, const CameraKey& key, double near_s) {
    const Places places(text);
    const SceneText now(places, scene);
    std::string result = text;
    if (now.keys.empty()) {
        // After the last member, indented as that is where it has a line of its own.
        const Piece& last = now.members.back();
        const std::string line = places.before_on_line(last);
        const std::string indent = line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
        return result.insert(last.end, ",\n" + indent + "\"camera\": {\"keys\": [\n" + indent + "\t" + key_text(key) +
                                           "\n" + indent + "]}");
    }
    if (const Piece* same = key_near(text, now.keys, key.time_s, near_s))
        return result.replace(same->begin, same->end - same->begin, key_text(key));
    // A line of its own where the neighbour has one.
    const auto gap = [&](const Piece& neighbour) {
        const std::string line = places.before_on_line(neighbour);
        return is_blank(line) ? "\n" + line : std::string(" ");
    };
    for (const Piece& later : now.keys)
        if (time_of(text, later) > key.time_s) return result.insert(later.begin, key_text(key) + "," + gap(later));
    return result.insert(now.keys.back().end, "," + gap(now.keys.back()) + key_text(key));
}

std::string without_key(const std::string& text, size_t scene, double time_s, double near_s) {
    const Places places(text);
    const SceneText now(places, scene);
    const Piece* gone = key_near(text, now.keys, time_s, near_s);
    if (!gone) throw InputError("there is no key within {:.2g} s of {:.6g} s", near_s, time_s);
    if (now.keys.size() == 1) throw InputError("it is the scene's only key");
    std::string result = text;
    // With the gap to the next key, or, of the last one, from the one before.
    if (gone != &now.keys.back()) return result.erase(gone->begin, (gone + 1)->begin - gone->begin);
    return result.erase((gone - 1)->end, gone->end - (gone - 1)->end);
}

}  // namespace lightwalk
