#include "19_ambiance/timeline.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/base/error.h"
#include "common/base/text.h"

namespace lightwalk {

namespace {

double smooth(double s) { return s * s * (3 - 2 * s); }

// "0.5" or "0.1,0.2,0.3" as numbers; none where it is a word.
std::vector<double> numbers(const std::string& text) {
    std::vector<double> all;
    size_t at = 0;
    while (at <= text.size()) {
        const size_t end = std::min(text.find(',', at), text.size());
        const std::string one = text.substr(at, end - at);
        char* parsed = nullptr;
        const double value = std::strtod(one.c_str(), &parsed);
        if (one.empty() || *parsed != '\0') return {};
        all.push_back(value);
        at = end + 1;
    }
    return all;
}

double value_of(const Fade& fade, double time_s) {
    const double share =
        fade.to_s > fade.from_s ? std::clamp((time_s - fade.from_s) / (fade.to_s - fade.from_s), 0.0, 1.0) : 1.0;
    return fade.from + share * (fade.to - fade.from);
}

double count_of(const Title& title, double time_s) {
    const double share = std::clamp((time_s - title.from_s) / (title.to_s - title.from_s), 0.0, 1.0);
    return glm::mix(title.count->x, title.count->y, share);
}

}  // namespace

std::string Track::at(double time_s) const {
    // A frame's time is a float: an entry has begun where that rounds to just before it.
    constexpr double rounded_s = 2e-5;
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s + rounded_s);
    if (after == times_s.begin()) return values.front();
    const auto i = static_cast<size_t>(after - times_s.begin()) - 1;
    if (steps || after == times_s.end()) return values[i];
    const std::vector<double> a = numbers(values[i]), b = numbers(values[i + 1]);
    if (a.empty() || a.size() != b.size()) return values[i];  // words
    const double share = std::max(time_s - times_s[i], 0.0) / (times_s[i + 1] - times_s[i]);
    std::string text;
    for (size_t k = 0; k < a.size(); ++k) text += fmt::format("{}{:.9g}", k ? "," : "", a[k] + share * (b[k] - a[k]));
    return text;
}

std::vector<Timeline::Shown> Timeline::shown(double time_s) const {
    std::vector<Shown> all;
    for (size_t i = 0; i < scenes.size(); ++i)
        if (scenes[i].from_s <= time_s && time_s < scenes[i].to_s) all.push_back({i, 1.0f});
    if (all.size() == 2) {
        const double from = scenes[all[1].scene].from_s,
                     to = std::min(scenes[all[0].scene].to_s, scenes[all[1].scene].to_s);
        all[1].share = static_cast<float>(smooth((time_s - from) / (to - from)));
        all[0].share = 1.0f - all[1].share;
    }
    return all;
}

std::vector<double> Timeline::turns(size_t scene) const {
    const FilmScene& of = scenes.at(scene);
    std::set<double> all{of.from_s};
    for (const CameraKey& key : of.camera.keys())
        if (const double at_s = key.time_s - of.clock_s + of.from_s; at_s > of.from_s)
            all.insert(std::min(at_s, of.to_s - 0.01));
    for (const Track& track : of.knobs)
        for (size_t i = 1; i < track.times_s.size(); ++i)
            if (const double at_s = track.times_s[i] - of.clock_s + of.from_s;
                at_s > of.from_s && at_s < of.to_s && (track.steps || numbers(track.values[i]).empty()))
                all.insert(at_s);
    return {all.begin(), all.end()};
}

Timeline::Faded Timeline::faded(double time_s) const {
    Faded now;
    for (const Fade& fade : fades)
        if (time_s >= fade.from_s) (fade.white ? now.white : now.black) = static_cast<float>(value_of(fade, time_s));
    return now;
}

std::string title_text(const Title& title, double time_s) {
    const size_t place = title.text.find("{}");
    if (!title.count || place == std::string::npos) return title.text;
    const auto number = std::llround(count_of(title, time_s));
    std::string digits = fmt::format("{}", number);
    for (size_t i = digits.size(); i > 3 + (number < 0); i -= 3) digits.insert(i - 3, ",");
    return title.text.substr(0, place) + digits + title.text.substr(place + 2);
}

float title_strength(const Title& title, double time_s) {
    constexpr double fade_s = 0.6;
    const double in = std::clamp((time_s - title.from_s) / fade_s, 0.0, 1.0);
    const double left_s = title.to_s - time_s,
                 out = title.stays ? (left_s >= 0 ? 1.0 : 0.0) : std::clamp(left_s / fade_s, 0.0, 1.0);
    return static_cast<float>(smooth(std::min(in, out)));
}

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
        const double first_s = std::max(fade.from_s, part.from_s), end_s = std::min(fade.to_s, part.to_s);
        cut.fades.push_back(
            {part.in_cut(first_s), part.in_cut(end_s), value_of(fade, first_s), value_of(fade, end_s), fade.white});
    }
}

void add_titles(const Timeline& film, const CutPart& part, Timeline& cut) {
    constexpr double least_s = 1.5;  // less cannot be read
    for (Title title : film.titles) {
        const double first_s = std::max(title.from_s, part.from_s), end_s = std::min(title.to_s, part.to_s);
        if (end_s - first_s < least_s) continue;
        if (title.count) title.count = glm::dvec2(count_of(title, first_s), count_of(title, end_s));
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

}  // namespace lightwalk
