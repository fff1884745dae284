#include "19_ambiance/path_error.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lightwalk {

void measure_paths(const Timeline& film, nlohmann::json& error) {
    double off = 0, speed = 1;
    for (const FilmScene& scene : film.scenes) {
        const CameraPath& path = scene.camera;
        if (path.keys().size() < 2) continue;
        off = std::max(off, off_the_chord(path.positions(), 64));
        constexpr int steps = 512;
        double slowest = 1e30, fastest = 0;
        const double begin = path.keys().front().time_s, whole = path.keys().back().time_s - begin;
        for (int i = 0; i < steps; ++i) {
            const double step =
                glm::distance(path.eye(begin + whole * i / steps), path.eye(begin + whole * (i + 1) / steps));
            slowest = std::min(slowest, step);
            fastest = std::max(fastest, step);
        }
        if (slowest > 0) speed = std::max(speed, fastest / slowest);
    }
    error["off_chord"] = off;
    error["speed"] = speed;
}

}  // namespace lightwalk
