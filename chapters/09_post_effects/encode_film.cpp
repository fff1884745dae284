#include "09_post_effects/encode_film.h"

#include "common/app/render.h"

namespace lightwalk {

static const Pipeline film = compute({.shader = "09_post_effects/film.comp"});

void encode_film(Frame& frame) {
    frame.apply_tones("encode_film", frame.hdr);
    accumulate(frame);
    frame.compute("film", {.reads = {frame.linear()}, .writes = {frame.output}}, [&](Compute& pass) {
        pass.use(film).set("hdr", frame.linear(), nearest_clamp).set("result", frame.output);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
