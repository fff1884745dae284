#include "18_playground/playground.h"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {

Playground::Playground() {
    set_look(bench, *this);
    picker.method.preferred = true;  // --method is about picking here
    antialias.method.change_default("none");
    objects.maps.in_use = [this] { return maps_due_; };
}

// Applies the document's changes before drawing. New resources are prepared, as after loading.
void Playground::bring_up_to_date(Gpu& gpu) {
    const auto give = [this](Scene& to) {
        for (const auto& one : arrived) one->give(to);
    };
    if (opens) try {
            editor.open(*this, gpu, *std::exchange(opens, std::nullopt), give);
        } catch (const InputError& e) { editor.notice = e.what(); }
    give(scene);
    arrived.clear();
    const bool replaced = editor.update(*this, gpu);
    bench.light.prepare(gpu, scene);  // unchanged surroundings and ambient light are kept
    bench.backdrop.shadow.prepare(gpu, scene);
    if (!replaced) return;
    const bool updates = std::exchange(updates_, false);
    maps_due_ = editor.loads;
    bench.substances.prepare(gpu, scene);
    try {
        bench.ground.follow(gpu, scene);
        if (bench.land.in_use()) bench.land.prepare(gpu, scene);  // at once, not when the scene is loaded next
    } catch (const InputError& e) { editor.notice = e.what(); }   // its file has changed since it was chosen
    picker.rays.prepare(gpu, scene);
    bench.backdrop.shadow.rays.prepare(gpu, scene);
    if (editor.loads) objects.maps.prepare(gpu, scene);
    maps_due_ = true;
    updates_ = updates;
}

// [frame]
void Playground::frame(Frame& frame) {
    bring_up_to_date(frame.gpu);
    const View view = view_now = look_at(bench, frame, scene, output_frame.seen(camera, frame.size));

    // 1. Item ids per pixel, after a click or with a selection.
    const bool asks = click.has_value(), marked = marks.on && (!editor.selection.ids.empty() || select >= 0);
    if (asks || marked || show.is("ids")) picker.record(frame, view, scene, objects.maps);
    if (asks) picker.pick(frame, *std::exchange(click, std::nullopt));

    // 2. The world in linear light, with anti-aliasing, bloom and tones; over it the editor's marks. Or only the numbers.
    if (show.is("ids")) {
        show_ids(frame);
    } else {
        Canvas canvas(frame.hdr, frame.depth, bench.background());
        bench.draw_light(frame, view, canvas);
        if (antialias.method.is("taa")) canvas.depth(frame);
        antialias.record(frame, frame.hdr, {view, frame.depth, &scene, bench.drawings()});
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        draw_marks(frame, view);
    }

    // 3. Linear light, encoded as sRGB.
    encode_srgb(frame);
}
// [/frame]

void Playground::show_ids(Frame& frame) {
    frame.compute("show ids", {.reads = {picker.ids}, .writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(show_ids_).set("ids", picker.ids, nearest_clamp).set("result", frame.hdr);
        pass.dispatch_threads(frame.size);
    });
}

void Playground::draw_marks(Frame& frame, const View& view) {
    if (!marks.on) return;
    if (select >= 0 && editor.selection.ids.empty()) {
        const EntryId id = editor.live.entry_of(static_cast<uint32_t>(select.value));
        if (id != no_entry) editor.selection.set({id});
    }
    if (editor.selection.ids.empty()) return;
    std::vector<MarkLine> lines;
    add_lights(lines, editor.document, editor.selection, view, editor.scale);
    if (const auto place =
            gizmo_place(editor.document, editor.selection, view, editor.tool, editor.local, editor.scale))
        add_gizmo(lines, *place, view, editor.hot);
    marks.record(frame, view, frame.hdr, picker, editor.selected_items(scene), lines, editor.scale);
}

void Playground::measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) { measure_picking(*this, gpu, size, error); }

std::vector<std::string> Playground::status() const {
    return {fmt::format("{} entries, {} lights, {} steps that can be undone ({:.1f} MB)", editor.document.size(),
                        objects.lights.buffer().lights().size(), editor.document.done(),
                        double(editor.document.bytes()) / 1e6)};
}

namespace {

std::vector<uint32_t> ids_of(Playground& chapter, Gpu& gpu, glm::uvec2 size) {
    Frame own(gpu);
    render(chapter, own, {size, 0.0f, 0, {}});
    const auto bytes = gpu.read_back(chapter.picker.ids);
    std::vector<uint32_t> ids(bytes.size() / sizeof(uint32_t));
    std::memcpy(ids.data(), bytes.data(), bytes.size());
    return ids;
}

}  // namespace

double wrong_picks(const std::vector<uint32_t>& found, const std::vector<uint32_t>& fine, glm::uvec2 size,
                   uint32_t times) {
    size_t wrong = 0;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            std::map<uint32_t, uint32_t> covered;
            uint32_t most = 0;
            for (uint32_t v = 0; v < times; ++v)
                for (uint32_t u = 0; u < times; ++u)
                    most = std::max(most, ++covered[fine[(y * times + v) * size.x * times + x * times + u]]);
            const auto own = covered.find(found[y * size.x + x]);
            const uint32_t share = own == covered.end() ? 0 : own->second;
            wrong += share + times * times / 8 < most;
        }
    return double(wrong) / double(size.x * size.y);
}

void measure_picking(Playground& chapter, Gpu& gpu, glm::uvec2 size, nlohmann::json& error) {
    constexpr uint32_t times = 8;
    const glm::uvec2 own = glm::min(size, glm::uvec2(240, 136));
    chapter.show.set("ids");
    const std::vector<uint32_t> found = ids_of(chapter, gpu, own);
    chapter.picker.method.set("ids");
    error["wrong_picks"] = wrong_picks(found, ids_of(chapter, gpu, own * times), own, times);
}

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
