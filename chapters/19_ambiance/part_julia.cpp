// Chapter 11's Julia sets, one turning into the next.
#include "11_fractals/julia.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct JuliaPart : FilmPart {
    using FilmPart::FilmPart;
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {julia});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_julia(const FilmScene& scene, Music& music) {
    return std::make_unique<JuliaPart>(scene, music);
}

}  // namespace lightwalk
