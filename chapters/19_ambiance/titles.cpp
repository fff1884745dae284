#include "19_ambiance/titles.h"

#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/shared_lock.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

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

namespace {

constexpr int across = 1024, down = 1536;  // texels of the image
constexpr float capital_px = 72.0f;        // height of a capital in it
constexpr int border_px = 15;              // around a letter: GLYPH_RANGE of a capital's height
constexpr unsigned char outline = 128;     // code of the outline

// The height of a capital, in the font's units.
float capital_units(const stbtt_fontinfo& font) {
    int left = 0, low = 0, right = 0, high = 0;
    stbtt_GetCodepointBox(&font, 'H', &left, &low, &right, &high);
    return static_cast<float>(std::max(high, 1));
}

}  // namespace

Typeface::Letters Typeface::drawn() {
    Letters all;
    const std::filesystem::path file = find_asset("fonts/inter_semibold.ttf");
    const std::string bytes = read_file(file);
    stbtt_fontinfo font;
    if (!stbtt_InitFont(&font, reinterpret_cast<const unsigned char*>(bytes.data()), 0))
        throw InputError("{}: not a font", file.string());
    const float capital = capital_units(font), scale = capital_px / capital;
    all.texels.assign(size_t(across) * down, 0);
    glm::ivec2 pen(0);
    int row = 0;
    for (char sign = ' '; sign <= '~'; ++sign) {
        int advance = 0, bearing = 0, width = 0, height = 0, x = 0, y = 0;
        stbtt_GetCodepointHMetrics(&font, sign, &advance, &bearing);
        Letter& letter = all.by_sign[sign];
        letter = {{}, static_cast<float>(advance) / capital};
        unsigned char* drawn = stbtt_GetCodepointSDF(&font, scale, sign, border_px, outline,
                                                     float(outline) / float(border_px), &width, &height, &x, &y);
        if (!drawn) continue;  // a blank
        if (pen.x + width > across) pen = {0, row};
        if (pen.y + height > down) throw InputError("{}: letters are larger than expected", file.string());
        for (int i = 0; i < height; ++i)
            std::copy_n(drawn + i * width, width, all.texels.begin() + (pen.y + i) * across + pen.x);
        stbtt_FreeSDF(drawn, nullptr);
        letter.drawn = {.lower = glm::vec2(glm::ivec2(x, -(y + height))) / capital_px,
                        .upper = glm::vec2(glm::ivec2(x + width, -y)) / capital_px,
                        .first = glm::vec2(pen),
                        .end = glm::vec2(pen + glm::ivec2(width, height))};
        row = std::max(row, pen.y + height + 1);
        pen.x += width + 1;
    }
    for (char a = ' '; a <= '~'; ++a)
        for (char b = ' '; b <= '~'; ++b)
            if (const int apart = stbtt_GetCodepointKernAdvance(&font, a, b))
                all.kerning[{a, b}] = static_cast<float>(apart) / capital;
    return all;
}

void Typeface::read() {
    if (letters_) return;
    letters_ = unlocked([] {
        static const Letters all = drawn();
        return &all;
    });
}

void Typeface::load(Gpu& gpu) {
    if (distances_) return;
    read();
    distances_ = Image(gpu.device,
                       {.name = "typeface", .format = VK_FORMAT_R8_UNORM, .size = {uint32_t(across), uint32_t(down)}});
    gpu.upload(distances_, std::as_bytes(std::span(letters_->texels)));
}

std::vector<Glyph> Typeface::line(const std::string& text, float& width) const {
    std::vector<Glyph> glyphs;
    float at = 0;
    char before = 0;
    for (const char sign : text) {
        const auto letter = letters_->by_sign.find(sign);
        const Letter& found = letter == letters_->by_sign.end() ? letters_->by_sign.at(' ') : letter->second;
        if (const auto apart = letters_->kerning.find({before, sign}); apart != letters_->kerning.end())
            at += apart->second;
        Glyph glyph = found.drawn;
        glyph.lower.x += at;
        glyph.upper.x += at;
        if (glyph.end.x > glyph.first.x) glyphs.push_back(glyph);
        at += found.advance;
        before = sign;
    }
    width = at;
    return glyphs;
}

}  // namespace lightwalk
