// The course's titles: within a screen's safe margins, and clear of the street's dividers.
#include "../catch.h"
#include "19_ambiance/timeline.h"
#include "19_ambiance/titles.h"

using namespace lightwalk;

namespace {

constexpr double wide = 16.0 / 9.0;  // of the picture, in heights

// A title's left and right end at its longest, in heights of the picture.
glm::dvec2 ends_of(const Typeface& face, const Title& title) {
    float width = 0;
    face.line(title_text(title, title.to_s), width);
    return {title.at.x, title.at.x + title.size * double(width)};
}

}  // namespace

TEST_CASE("titles keep a distance of 5% from the edges of the picture", "[safe_margins]") {
    Typeface face;
    face.read();
    for (const Title& title : read_timeline(find_asset("films/ambiance.film")).titles) {
        const glm::dvec2 ends = ends_of(face, title);
        INFO(title.text << " from " << ends.x << " to " << ends.y);
        CHECK(ends.x >= 0.05 * wide);
        CHECK(ends.y <= 0.95 * wide);
        CHECK(title.at.y >= 0.05);
        CHECK(title.at.y + title.size <= 0.95);
    }
}

TEST_CASE("the street's words do not cross its dividers", "[dividers]") {
    Typeface face;
    face.read();
    const Timeline film = read_timeline(find_asset("films/ambiance.film"));
    for (const FilmScene& scene : film.scenes)
        for (const Title& title : film.titles) {
            if (scene.kind != "street" || title.from_s >= scene.to_s || title.to_s <= scene.from_s) continue;
            const glm::dvec2 ends = ends_of(face, title) / (0.25 * wide);
            INFO(title.text << " from " << ends.x << " to " << ends.y << " strips");
            CHECK(std::floor(ends.x) == std::floor(ends.y));
        }
}
