// Chapter 14's statue, car and sphere, in the light of what is around them.
#include "14_environment/backdrop.h"
#include "14_environment/beat_sphere.h"
#include "14_environment/lit_around.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct SurroundingsPart : FilmPart {
    SurroundingsPart(const FilmScene& scene, Music& music) : FilmPart(scene, music) {
        objects.maps.method.change_default("normal");
        backdrop.shadow.maps = &objects.maps;
    }
    ImageLight light{*this, "environment"};
    Backdrop backdrop{*this, "backdrop", light};
    LitAround objects{*this, "objects", light};
    BeatSphere sphere{*this, "sphere", light, music_};

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        light.record(frame, scene_);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene_.file.background, 1.0f));
        draw(frame, view, canvas, {backdrop, objects, sphere});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_surroundings(const FilmScene& scene, Music& music) {
    return std::make_unique<SurroundingsPart>(scene, music);
}

}  // namespace lightwalk
