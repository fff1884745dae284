// Shorter versions of a film, made of its parts.
#include <fmt/core.h>

#include <algorithm>

#include "19_ambiance/timeline.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

// A part of the whole film, and its time in the cut.
struct CutPart {
    double from_s, to_s, begins_s;

    double in_cut(double time_s) const { return begins_s + std::clamp(time_s, from_s, to_s) - from_s; }
    bool shows(double a_s, double b_s) const { return a_s < to_s && b_s > from_s; }
};

void add_scenes(const Timeline& film, const CutPart& part, Timeline& cut) {
    for (FilmScene scene : film.scenes) {
        if (!part.shows(scene.from_s, scene.to_s)) continue;
        scene.clock_s = scene.clock_at(std::max(scene.from_s, part.from_s));
        scene.from_s = part.in_cut(scene.from_s);
        scene.to_s = part.in_cut(scene.to_s);
        const auto same = std::count_if(cut.scenes.begin(), cut.scenes.end(), [&](const FilmScene& other) {
            return other.name == scene.name || other.name.rfind(scene.name + " ", 0) == 0;
        });
        if (same > 0) scene.name += fmt::format(" {}", same + 1);
        cut.scenes.push_back(std::move(scene));
    }
}

// The fade at the part's beginning, then the fades within it.
void add_fades(const Timeline& film, const CutPart& part, Timeline& cut) {
    const Timeline::Faded at_first = film.faded(part.from_s);
    const auto rests = [&](float value, bool white) {
        return Fade{part.begins_s, part.begins_s, double(value), double(value), white};
    };
    cut.fades.push_back(rests(at_first.black, false));
    cut.fades.push_back(rests(at_first.white, true));
    for (const Fade& fade : film.fades) {
        if (fade.from_s < part.from_s ? fade.to_s <= part.from_s : fade.from_s >= part.to_s) continue;
        const auto value = [&](double time_s) {
            const double share = fade.to_s > fade.from_s ? (time_s - fade.from_s) / (fade.to_s - fade.from_s) : 1.0;
            return glm::mix(fade.from, fade.to, std::clamp(share, 0.0, 1.0));
        };
        const double first_s = std::max(fade.from_s, part.from_s), end_s = std::min(fade.to_s, part.to_s);
        cut.fades.push_back({part.in_cut(first_s), part.in_cut(end_s), value(first_s), value(end_s), fade.white});
    }
}

void add_titles(const Timeline& film, const CutPart& part, Timeline& cut) {
    constexpr double least_s = 1.5;  // less cannot be read
    for (Title title : film.titles) {
        const double first_s = std::max(title.from_s, part.from_s), end_s = std::min(title.to_s, part.to_s);
        if (end_s - first_s < least_s) continue;
        if (title.count) {
            const auto count = [&](double time_s) {
                return glm::mix(title.count->x, title.count->y, (time_s - title.from_s) / (title.to_s - title.from_s));
            };
            title.count = glm::dvec2(count(first_s), count(end_s));
        }
        title.from_s = part.in_cut(first_s);
        title.to_s = part.in_cut(end_s);
        cut.titles.push_back(std::move(title));
    }
}

// The track's values between the cut's joints, which stay sharp.
void add_entries(const Track& track, const CutPart& part, Track& cut) {
    constexpr double joint_s = 1e-5;
    const auto add = [&](double time_s, double in_cut_s) {
        cut.times_s.push_back(in_cut_s);
        cut.values.push_back(track.at(time_s));
    };
    add(part.from_s, part.begins_s);
    for (const double time_s : track.times_s)
        if (time_s > part.from_s + joint_s && time_s < part.to_s - 2 * joint_s) add(time_s, part.in_cut(time_s));
    add(part.to_s - joint_s, part.in_cut(part.to_s) - joint_s);
}

}  // namespace

// [cut_of]
Timeline cut_of(const Timeline& film, const std::string& name) {
    const auto found = film.cuts.find(name);
    if (found == film.cuts.end()) throw InputError("{}: the film has no cut '{}'", film.file.string(), name);
    Timeline cut;
    cut.file = film.file;
    cut.music = film.music;
    cut.music.from_s = found->second.music_from_s;
    std::vector<CutPart> parts;
    double begins_s = 0;
    for (const glm::dvec2 times : found->second.parts) {
        parts.push_back({times.x, times.y, begins_s});
        begins_s += times.y - times.x;
    }
    cut.duration_s = begins_s;
    for (const CutPart& part : parts) {
        add_scenes(film, part, cut);
        add_fades(film, part, cut);
        add_titles(film, part, cut);
    }
    for (const Track& track : film.knobs) {
        Track shorter{.name = track.name, .steps = track.steps, .times_s = {}, .values = {}, .where = track.where};
        for (const CutPart& part : parts) add_entries(track, part, shorter);
        cut.knobs.push_back(std::move(shorter));
    }
    return cut;
}
// [/cut_of]

}  // namespace lightwalk
