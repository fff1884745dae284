#include "19_ambiance/titles.h"

#include <cctype>
#include <cmath>

namespace lightwalk {
namespace {

// Points on a grid four wide and six high, as letters for x (a to e) and digits for y (0 to 6). A stroke goes from one to the
// next; a blank lifts the pen.
struct Letter {
    char sign;
    float width;  ///< in grid cells, without the gap to the next
    const char* pen;
};
constexpr Letter alphabet[] = {
    {'A', 4, "a0c6e0 b2d2"},
    {'B', 4, "a0a6d6e5e4d3a3 d3e2e1d0a0"},
    {'C', 4, "e5d6b6a5a1b0d0e1"},
    {'D', 4, "a0a6c6e4e2c0a0"},
    {'E', 4, "e0a0a6e6 a3d3"},
    {'F', 4, "a0a6e6 a3d3"},
    {'G', 4, "e5d6b6a5a1b0d0e1e3c3"},
    {'H', 4, "a0a6 e0e6 a3e3"},
    {'I', 0, "a0a6"},
    {'J', 3, "d6d1c0b0a1"},
    {'K', 4, "a0a6 e6a2 b3e0"},
    {'L', 3, "a6a0d0"},
    {'M', 4, "a0a6c2e6e0"},
    {'N', 4, "a0a6e0e6"},
    {'O', 4, "b0a1a5b6d6e5e1d0b0"},
    {'P', 4, "a0a6d6e5e4d3a3"},
    {'Q', 4, "b0a1a5b6d6e5e1d0b0 c2e0"},
    {'R', 4, "a0a6d6e5e4d3a3 c3e0"},
    {'S', 4, "e5d6b6a5a4b3d3e2e1d0b0a1"},
    {'T', 4, "a6e6 c6c0"},
    {'U', 4, "a6a1b0d0e1e6"},
    {'V', 4, "a6c0e6"},
    {'W', 4, "a6b0c4d0e6"},
    {'X', 4, "a0e6 a6e0"},
    {'Y', 4, "a6c3e6 c3c0"},
    {'Z', 4, "a6e6a0e0"},
    {'0', 4, "b0a1a5b6d6e5e1d0b0"},
    {'1', 2, "a5b6b0"},
    {'2', 4, "a5b6d6e5e4a0e0"},
    {'3', 4, "a5b6d6e5e4d3b3 d3e2e1d0b0a1"},
    {'4', 4, "d0d6a2e2"},
    {'5', 4, "e6a6a3d3e2e1d0b0a1"},
    {'6', 4, "d6b6a5a1b0d0e1e2d3a3"},
    {'7', 4, "a6e6b0"},
    {'8', 4, "b3a4a5b6d6e5e4d3b3a2a1b0d0e1e2d3"},
    {'9', 4, "a1b0d0e1e5d6b6a5a4b3e3"},
    {'.', 0, "a0a0"},
    {',', 1, "b1a0"},
    {':', 0, "a1a1 a4a4"},
    {'-', 3, "a3d3"},
    {'/', 4, "a0e6"},
    {'(', 2, "c6b4b2c0"},
    {')', 2, "a6b4b2a0"},
    {'+', 4, "a3e3 c1c5"},
    {'\'', 0, "a6a5"},
    {'&', 4, "e0a4a5b6c5c4a2a1b0c0e2"},
};
constexpr float cell = 1.0f / 6, gap = 2.2f, blank = 3.4f;

const Letter* find_letter(char sign) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(sign)));
    for (const Letter& letter : alphabet)
        if (letter.sign == capital) return &letter;
    return nullptr;
}

}  // namespace

std::vector<Stroke> strokes_of(const std::string& text, float& width) {
    std::vector<Stroke> strokes;
    float at = 0;
    for (const char sign : text) {
        const Letter* letter = find_letter(sign);
        if (!letter) {
            at += blank;
            continue;
        }
        const auto point = [&](const char* pen) {
            return cell * glm::vec2(at + static_cast<float>(pen[0] - 'a'), static_cast<float>(pen[1] - '0'));
        };
        for (const char* pen = letter->pen; pen[0]; pen += pen[2] == ' ' ? 3 : 2)
            if (pen[2] && pen[2] != ' ') strokes.push_back({point(pen), point(pen + 2)});
        at += letter->width + gap;
    }
    width = cell * at;
    return strokes;
}

// [titles]
void Titles::record(Frame& frame, const Image& picture, const Timeline& film, double time_s) {
    struct Block {
        glm::vec2 first, end, origin;
        float scale, strength;
        uint32_t begin, count;
    };
    std::vector<Stroke> strokes;
    std::vector<Block> blocks;
    const glm::vec2 size(frame.size), whole(frame.crop.whole == glm::uvec2(0) ? frame.size : frame.crop.whole);
    for (const Title& title : film.titles) {
        const float strength = title_strength(title, time_s);
        if (strength <= 0) continue;
        float width = 0;
        const std::vector<Stroke> letters = strokes_of(title_text(title, time_s), width);
        const float scale = static_cast<float>(title.size) * whole.y, around = 0.4f * scale;
        const glm::vec2 at(title.at);
        const glm::vec2 origin = glm::vec2(at.x * whole.y, whole.y - at.y * whole.y) - glm::vec2(frame.crop.origin);
        const glm::vec2 first = glm::max(glm::floor(origin - glm::vec2(around, scale + around)), glm::vec2(0));
        const glm::vec2 end = glm::min(glm::ceil(origin + glm::vec2(width * scale + around, around)), size);
        if (end.x <= first.x || end.y <= first.y) continue;
        blocks.push_back({first, end, origin, scale, strength, uint32_t(strokes.size()), uint32_t(letters.size())});
        strokes.insert(strokes.end(), letters.begin(), letters.end());
    }
    if (strokes.empty()) return;
    frame.upload("strokes", strokes_, strokes);
    frame.compute("titles", {.reads = {strokes_, picture}, .writes = {picture}}, [&](Compute& pass) {
        pass.use(draw_).set("strokes", strokes_).set("picture", picture);
        for (const Block& block : blocks) {
            pass.set("title", block).dispatch_threads(glm::uvec2(block.end - block.first));
            pass.wait();
        }
    });
}
// [/titles]

}  // namespace lightwalk
