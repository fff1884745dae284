#include "18_playground/editor_ball.h"

#include <algorithm>
#include <cmath>

#include "18_playground/widgets.h"

namespace lightwalk {

// It is drawn when nobody drags: a new material means its textures' levels again.
void MaterialBall::draw(EntryId id, const DrawItem& item) {
    SceneFile shows = material_ball(*editor.document.at(id).object(), item);
    if (!files_.is_current(scene.images())) {  // they were read again
        preview.forget();
        made_.forget();
    }
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) && !made_.is_current(scene_text(shows))) due_ = std::move(shows);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float pixel = std::max(1.0f, std::floor(ImGui::GetFontSize() / 15.0f));
    if (picture_.width) draw_pixels(picture_, at, pixel);
    ImGui::Dummy({pixel * float(size), pixel * float(size)});
    log_place("ball");
}

void MaterialBall::make() {
    picture_ = preview.draw(*view_.gpu, *std::exchange(due_, std::nullopt), glm::uvec2(size));
    log_event("ball drawn");
    view_.changed = true;
}

}  // namespace lightwalk
