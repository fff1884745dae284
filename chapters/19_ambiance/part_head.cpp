// Chapter 12's head.
#include "12_skin/head.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct HeadPart : FilmPart {
    HeadPart(const FilmScene& scene, Music& music) : FilmPart(scene, music) {
        objects.maps.method.change_default("normal");
    }
    LitScene objects{*this, "objects"};  // its lights and maps; the head is what is drawn
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {head});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_head(const FilmScene& scene, Music& music) {
    return std::make_unique<HeadPart>(scene, music);
}

}  // namespace lightwalk
