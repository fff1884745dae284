#include "19_ambiance/titles.h"

namespace lightwalk {

// [titles]
void Titles::record(Frame& frame, const Image& picture, const Timeline& film, double time_s) {
    struct Block {
        glm::vec2 first, end, origin;
        float scale, strength;
        uint32_t begin, count;
    };
    std::vector<Glyph> glyphs;
    std::vector<Block> blocks;
    const glm::vec2 size(frame.size), whole(frame.crop.whole == glm::uvec2(0) ? frame.size : frame.crop.whole);
    for (const Title& title : film.titles) {
        const float strength = title_strength(title, time_s);
        if (strength <= 0) continue;
        float width = 0;
        face_.load(frame.gpu);
        const std::vector<Glyph> line = face_.line(title_text(title, time_s), width);
        const float scale = static_cast<float>(title.size) * whole.y, around = 0.5f * scale;
        const glm::vec2 at(title.at);
        const glm::vec2 origin = glm::vec2(at.x * whole.y, whole.y - at.y * whole.y) - glm::vec2(frame.crop.origin);
        const glm::vec2 first = glm::max(glm::floor(origin - glm::vec2(around, scale + around)), glm::vec2(0));
        const glm::vec2 end = glm::min(glm::ceil(origin + glm::vec2(width * scale + around, around)), size);
        if (end.x <= first.x || end.y <= first.y) continue;
        blocks.push_back({first, end, origin, scale, strength, uint32_t(glyphs.size()), uint32_t(line.size())});
        glyphs.insert(glyphs.end(), line.begin(), line.end());
    }
    if (glyphs.empty()) return;
    const auto bytes = std::as_bytes(std::span(glyphs));
    if (!glyphs_made_.is_current(std::vector(bytes.begin(), bytes.end()))) frame.upload("letters", glyphs_, glyphs);
    frame.compute("titles", {.reads = {glyphs_, picture}, .writes = {picture}}, [&](Compute& pass) {
        pass.use(draw_).set("glyphs", glyphs_).set("picture", picture);
        pass.set("distances", face_.distances(), linear_clamp);
        for (const Block& block : blocks) {
            pass.set("title", block).dispatch_threads(glm::uvec2(block.end - block.first));
            pass.wait();
        }
    });
}
// [/titles]

}  // namespace lightwalk
