#include "18_playground/playground.h"

#include <fmt/core.h>

#include "03_attenuation/scattered_lights.h"
#include "18_playground/picking_error.h"

namespace lightwalk {

Playground::Playground() {
    picker.method.alone = true;  // --method is about picking here
    objects.gbuffer.method.change_default("forward");
    objects.maps.method.change_default("normal");
    objects.shading = &surface_;
    objects.shaded.reset();
    objects.transparent_shading = &glass_;
    objects.writing = &write_, objects.rest = &rest_;
    objects.shading_with = {light, substances, paint};
    objects.all_lights = [this](const Frame& frame) {
        std::vector<Light> all = scene.lights();
        const std::vector<Light> more = scatter_lights(scene.bounds, scattered, frame.seed);
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    backdrop.shadow.maps = &objects.maps;
    objects.maps.in_use = [this] { return maps_due_; };
    sky.map.change_default("plain");
    water.method.change_default("none");
    fog.method.change_default("none");
    antialias.method.change_default("none");
    bloom.method.change_default("none");
    water.in_use = [this] { return !water.method.is("none"); };
    probe.update.change_default("moved");
    probe.distant = true;
    atmosphere.in_use = sky.in_use = probe.in_use = [this] { return air.is("sky"); };
}

// The document's changes, before anything is drawn. What a step adds has to be prepared, as after loading.
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
    light.prepare(gpu, scene);  // it keeps what it has where surroundings and ambient light are as they were
    if (done != LiveScene::Done::replaced) return;
    const bool updates = std::exchange(updates_, false);
    maps_due_ = editor.loads;
    substances.prepare(gpu, scene);
    picker.rays.prepare(gpu, scene);
    if (editor.loads) objects.maps.prepare(gpu, scene);
    maps_due_ = true, updates_ = updates;
}

// [frame]
void Playground::frame(Frame& frame) {
    bring_up_to_date(frame.gpu);
    const View view = view_now = set_view(frame);
    if (air.is("sky"))
        scene.set_sun(atmosphere.sun());
    else
        scene.forget_sun();

    // 1. What is in which pixel, where somebody clicks or something is selected.
    const bool asks = click.has_value(), marked = marks.on && (!editor.selection.ids.empty() || select >= 0);
    if (asks || marked || show.is("ids")) picker.record(frame, view, scene, objects.maps);
    if (asks) picker.pick(frame, *std::exchange(click, std::nullopt));

    // 2. The world in linear light, with anti-aliasing, bloom and tones; over it the editor's marks. Or only the numbers.
    if (show.is("ids")) {
        show_ids(frame);
    } else {
        draw_world(frame, view);
        antialias.record(frame, frame.hdr);
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        draw_marks(frame, view);
    }

    // 3. The codes that a screen expects.
    encode_srgb(frame);
}
// [/frame]

// [world]
void Playground::draw_world(Frame& frame, const View& view) {
    light.record(frame, scene);
    paint.record(frame);
    Drawings drawn{backdrop, objects};
    if (air.is("sky")) {  // which has its sun: what is reflected is this sky, and not the scene's environment
        probe.record(frame, scene, light, {sky, atmosphere.without_disc()});
        drawn = {objects, sky};
    }
    if (!water.method.is("none")) {
        // The water has the sun's glitter itself.
        water.reflect(frame, view, {objects}, air.is("sky") ? Drawings{sky, atmosphere.without_disc()} : Drawings{});
        drawn.push_back(water);
    }
    if (air.is("sky")) drawn.push_back(atmosphere);
    drawn.push_back(fog);
    Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
    draw(frame, view, canvas, drawn);
}
// [/world]

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
    add_lights(lines, editor.document, editor.selection, view);
    if (const auto place = gizmo_place(editor.document, editor.selection, view, editor.tool, editor.local))
        add_gizmo(lines, *place, view, editor.hot);
    marks.record(frame, view, frame.hdr, picker, editor.selected_items(scene), lines);
}

void Playground::measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) { measure_picking(*this, gpu, size, error); }

std::vector<std::string> Playground::status() const {
    return {fmt::format("{} entries, {} lights, {} steps that can be undone ({:.1f} MB)", editor.document.size(),
                        objects.lights.buffer().lights().size(), editor.document.done(),
                        double(editor.document.bytes()) / 1e6)};
}

}  // namespace lightwalk
