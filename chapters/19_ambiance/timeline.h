// A film as a file: scenes in order, with their cuts, fades, knobs, cameras and titles.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "19_ambiance/camera_path.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// The text of a film in which the camera of `scene` (its place in the film) has a key: instead of the one that is
/// within near_s of its time, else as a line of its own between its neighbours; a scene without a camera gets one.
/// `text` is a right film. Times and lengths are rounded to thousandths.
std::string with_key(const std::string& text, size_t scene, const CameraKey& key, double near_s);

/// The text without the key that is within near_s of a time of the scene. Throws InputError where there is none, or no
/// other.
std::string without_key(const std::string& text, size_t scene, double time_s, double near_s);

/// A key as it stands in a film.
std::string key_text(const CameraKey& key);

// [timeline_format]
// A .film file is JSON. Times are seconds of the film unless they are a scene's own.
//
//   music        file of an Ogg Vorbis piece, from 0 s on
//   music_gain_db  gain of the music in a film that is written (0): -14 LUFS is what players expect
//   duration_s   required, 0.1 to 3600
//   knobs        {name: value} of the whole film, as a scene has them; tracks run in the film's time. What is set on the
//                command line stays as it is
//   scenes       list, by from_s:
//     name         required, each once
//     kind         required: the world that draws it (planets, landscape, water, volume, julia, head, surroundings, lights,
//                  street, workbench, descent, outlines, stage, islands, fractal, surfaces, lens)
//     scene        required: its scene file
//     from_s, to_s required. If a scene begins where the one before ends, the film cuts to it; if it begins earlier, the
//                  film cross-fades to it while both are on. Never three at once; in a gap the screen is black.
//     clock_s      its own clock at from_s (0)
//     knobs        {name: value} for the knobs of its drawings. Instead of a value there may be a track, [[scene time,
//                  value], ...]. Numbers and colours are interpolated between its entries; values that are words jump, and
//                  so do all values if the track's first entry is "steps"
//     camera       spline ("centripetal"; linear, catmull_rom), even_speed (false), smooth_speed (true: keys are passed at
//                  their times, and the speed does not jump there), keys: list of time_s (scene time, rising), position,
//                  target, up ([0, 1, 0]), fov_deg (the scene file's)
//   fades        list of from_s, to_s, from, to (0 to 1), color ("black" or "white"). After a fade its last value
//                  holds until the next fade of its colour begins
//   titles       list of from_s, to_s, text, size (0.05, of the picture's height), at ([0.1, 0.1], from the left and
//                  from below, in heights), count ([from, to]: a number that replaces {} in the text). A title
//                  that ends with the film stays on its last frame
//   cuts         {name: {parts: [[from_s, to_s], ...], music_from_s}}: shorter versions, made of parts of this one; the
//                  music goes on under them from music_from_s
// [/timeline_format]

/// A knob's value over a scene's time.
struct Track {
    std::string name;  ///< of a knob of the scene's part
    bool steps = false;
    std::vector<double> times_s;
    std::vector<std::string> values;  ///< as KnobBase::set() takes them
    std::string where;                ///< "file:line: key", for errors found when it is applied

    /// The text for the knob at a scene's time: before the first and after the last entry it rests.
    std::string at(double time_s) const;
};

struct FilmScene {
    std::string name, kind;
    std::filesystem::path file;  ///< relative to assets/, or absolute
    double from_s = 0, to_s = 0, clock_s = 0;
    std::vector<Track> knobs;
    CameraPath camera;
    PathKind path;  ///< as the film says
    std::string where;

    double clock_at(double time_s) const { return time_s - from_s + clock_s; }
};

struct Fade {
    double from_s = 0, to_s = 0, from = 0, to = 1;
    bool white = false;
};

struct Title {
    double from_s = 0, to_s = 0;
    std::string text;
    double size = 0.05;
    glm::dvec2 at{0.1, 0.1};
    std::optional<glm::dvec2> count;
    bool stays = false;  ///< on the film's last frame
};

/// A shorter version of a film.
struct Cut {
    std::vector<glm::dvec2> parts;  ///< from and to, seconds of the whole film
    double music_from_s = 0;
};

/// A film's piece, its gain where the film is written, and its time at 0 s of the film.
struct FilmMusic : SceneMusic {
    double gain_db = 0, from_s = 0;
};

struct Timeline {
    std::filesystem::path file;
    FilmMusic music;
    double duration_s = 1;
    std::vector<Track> knobs;       ///< of the whole film
    std::vector<FilmScene> scenes;  ///< by from_s
    std::vector<Fade> fades;        ///< by from_s
    std::vector<Title> titles;
    std::map<std::string, Cut> cuts;

    /// What is on at a time, at most two; `share` of the later one rises smoothly over a cross-fade.
    struct Shown {
        size_t scene;
        float share;  ///< of the picture; all together 1
    };
    std::vector<Shown> shown(double time_s) const;

    /// When a scene may need something that it did not need before: at its beginning, where a track jumps, and at
    /// its camera's keys, from which other things are seen. In order.
    std::vector<double> turns(size_t scene) const;

    /// How far the picture is faded, each from 0 to 1.
    struct Faded {
        float black = 0, white = 0;
    };
    Faded faded(double time_s) const;
};

/// Reads a .film file. Throws InputError, "file:line: key 'name' what is wrong".
Timeline read_timeline(const std::filesystem::path& path);
Timeline parse_timeline(const std::string& text, const std::filesystem::path& path);

/// The film's cut of that name as a film. Throws InputError where there is none.
Timeline cut_of(const Timeline& film, const std::string& name);

/// The title's text at a time, with its number; and how visible it is, 0 to 1: it comes and goes in 0.6 s.
std::string title_text(const Title& title, double time_s);
float title_strength(const Title& title, double time_s);

}  // namespace lightwalk
