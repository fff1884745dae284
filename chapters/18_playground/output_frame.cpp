#include "18_playground/output_frame.h"

#include <cmath>

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

constexpr float shapes[] = {0.0f, 4.0f / 3.0f, 16.0f / 9.0f, 2.39f, 1.0f};

float aspect_of(glm::uvec2 size) { return static_cast<float>(size.x) / static_cast<float>(std::max(size.y, 1u)); }

}  // namespace

const std::vector<const char*>& OutputFrame::names() {
    static const std::vector<const char*> all{"the window", "4:3", "16:9", "2.39:1", "1:1"};
    return all;
}

Camera OutputFrame::seen(const Camera& camera, glm::uvec2 size) const {
    Camera wider = camera;
    if (shape > 0 && aspect_of(size) < shapes[shape])
        wider.fov_y_rad = 2.0f * std::atan(std::tan(0.5f * camera.fov_y_rad) * shapes[shape] / aspect_of(size));
    return wider;
}

Area OutputFrame::area(glm::uvec2 size) const {
    if (shape == 0) return {{0, 0}, size};
    const float width = std::min(static_cast<float>(size.x), static_cast<float>(size.y) * shapes[shape]);
    const glm::uvec2 inside(glm::round(glm::vec2(width, width / shapes[shape])));
    return {(size - glm::min(inside, size)) / 2u, inside};
}

void OutputFrame::draw(const Area& picture, float scale) const {
    if (shape == 0) return;
    const Area inside = area(picture.size);
    const glm::vec2 low(picture.corner), high(picture.corner + picture.size), from = low + glm::vec2(inside.corner),
                                                                              to = from + glm::vec2(inside.size);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImU32 dark = ImGui::GetColorU32({0.0f, 0.0f, 0.0f, 0.6f});
    list.AddRectFilled({low.x, low.y}, {high.x, from.y}, dark);
    list.AddRectFilled({low.x, to.y}, {high.x, high.y}, dark);
    list.AddRectFilled({low.x, from.y}, {from.x, to.y}, dark);
    list.AddRectFilled({to.x, from.y}, {high.x, to.y}, dark);
    list.AddRect({from.x, from.y}, {to.x, to.y}, ImGui::GetColorU32({1.0f, 1.0f, 1.0f, 0.8f}), 0.0f, 0, scale);
}

}  // namespace lightwalk
