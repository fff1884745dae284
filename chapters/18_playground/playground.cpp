#include "18_playground/playground.h"

#include <fmt/core.h>

#include "18_playground/picking_error.h"

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
    const LiveScene::Done done = editor.update(*this, gpu);
    bench.light.prepare(gpu, scene);  // unchanged surroundings and ambient light are kept
    if (done == LiveScene::Done::painted) bench.probe.prepare(gpu, scene);  // it shows the colours
    if (done != LiveScene::Done::replaced) return;
    const bool updates = std::exchange(updates_, false);
    maps_due_ = editor.loads;
    bench.substances.prepare(gpu, scene);
    try {
        bench.ground.follow(gpu, scene);
        if (bench.land.in_use()) bench.land.prepare(gpu, scene);  // at once, not when the scene is loaded next
    } catch (const InputError& e) { editor.notice = e.what(); }   // its file has changed since it was chosen
    picker.rays.prepare(gpu, scene);
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

}  // namespace lightwalk
