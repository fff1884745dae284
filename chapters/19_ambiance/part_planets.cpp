// The solar system, by chapter 17: the scene's camera, or a flight from body to body.
#include "17_planets/flight.h"
#include "17_planets/stars.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct PlanetsPart : FilmPart {
    using FilmPart::FilmPart;
    Planets planets{*this, "planets"};
    Stars stars{*this, "stars", planets};
    Flight flight{*this, "flight", planets};

    void draw_light(Frame& frame, const Camera& from) override {
        planets.exposed_for_m.reset();
        Camera camera = from;
        std::optional<glm::dvec3> exact_eye;
        if (flight.on) {
            const double time_s = static_cast<double>(frame.time_s);
            const Flight::Moment moment = flight.at(time_s, planets.days_at(time_s));
            camera = flight.camera(moment, from);
            exact_eye = moment.eye_m;
        }
        View view = look(frame, camera);
        view.exact_eye = exact_eye;
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {stars, planets});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_planets(const FilmScene& scene, Music& music) {
    return std::make_unique<PlanetsPart>(scene, music);
}

}  // namespace lightwalk
