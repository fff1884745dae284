// Chapter 11's endless landscape under chapter 10's air and in its fog.
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "11_fractals/terrain.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct LandscapePart : FilmPart {
    LandscapePart(const FilmScene& scene, Music& music) : FilmPart(scene, music) { terrain.own_sky = false; }
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    HeightFog fog{*this, "fog"};
    Terrain terrain{*this, "terrain"};

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        scene_.set_sun(atmosphere.sun());
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {terrain, sky, atmosphere, fog});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_landscape(const FilmScene& scene, Music& music) {
    return std::make_unique<LandscapePart>(scene, music);
}

}  // namespace lightwalk
