#include "19_ambiance/ambiance.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "19_ambiance/benchmark.h"
#include "19_ambiance/reel.h"
#include "19_ambiance/ways.h"
#include "common/app/knob_scope.h"

namespace lightwalk {

Ambiance::Ambiance() {
    method.preferred = true;
    post.tone.change_default("off");  // the scenes have their own
    objects.in_use = [this] { return !reel.is_open(); };
    reel.before_scenes = [this](Gpu& gpu) { make_effects(gpu); };
    commands = {
        {"levels", "FILE", "Write the levels of the music FILE beside it, for films, and exit",
         [](const std::string& file, const Options&, auto&) {
             write_levels(file);
             return 0;
         }},
        {"film", "FILE", "Write the film to FILE (.mp4, .mkv, .raw), and exit",
         [this](const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu) {
             return out.write(*this, reel, file, options, gpu);
         }},
        {"benchmark", "FILE", "Write what each scene costs as JSON, and exit",
         [this](const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu) {
             return run_benchmark(*this, reel, antialias, file, options, gpu);
         }},
        {"ways", "FILE", "Write what each scene costs in each way, and how far it is from the best, as JSON, and exit",
         [this](const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu) {
             return write_ways(*this, reel, file, options, gpu);
         }}};
}

void Ambiance::prepare_frame(Gpu& gpu, glm::uvec2 size, float time_s) {
    std::optional<PathKind> kind;
    if (!method.is("as_set")) kind = {static_cast<Spline>(std::min<size_t>(method.index - 1, 2)), 0};
    if (method.is("smooth_speed")) kind->smooth_speed = true;
    if (method.is("arc_length")) kind->pieces = 64;
    if (method.is("exact")) kind->pieces = 1024;
    reel.choose(kind);
    if (plays) reel.load_sound();
    reel.prepare_frame(gpu, size, static_cast<double>(time_s), out.latest_s(samples), plays);
}

// A cut is no motion: the history of a picture begins where its scene does.
float Ambiance::gathered_at(float time_s, int frames_before) const {
    if (!reel.is_open()) return Chapter::gathered_at(time_s, frames_before);
    auto from_s = static_cast<float>(reel.steady_from_s(static_cast<double>(time_s)));
    if (static_cast<double>(from_s) < reel.steady_from_s(static_cast<double>(time_s)))
        from_s = std::nextafter(from_s, time_s + 1.0f);
    return std::min(time_s, std::max(from_s, Chapter::gathered_at(time_s, frames_before)));
}

// A film's grain is that of a picture of 1,080 lines: a larger pixel shows the mean of several grains.
static float grain_of(float by, const Frame& frame) {
    const glm::uvec2 whole = frame.crop.whole == glm::uvec2(0) ? frame.size : frame.crop.whole;
    return by * std::min(1.0f, static_cast<float>(whole.y) / 1080.0f);
}

// [frame]
void Ambiance::frame(Frame& frame) {
    const double time_s = static_cast<double>(frame.time_s) + out.later_s(frame.samples.index, frame.samples.count);

    // 1. What the timeline says of the whole film: grain, dispersion, anti-aliasing.
    reel.apply_knobs(*this, time_s);
    const KnobScope grain(post.grain_by, fmt::format("{:.9g}", grain_of(post.grain_by, frame)));

    // 2. What is on at this time: one scene, or two; or the one scene that was given.
    View view;
    const Scene* seen = &scene;
    if (reel.is_open()) {
        reel.record(frame, time_s, camera);
        seen = reel.alone() ? &reel.alone()->drawn() : nullptr;
        if (seen) view = reel.alone()->view();
    } else {
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view = set_view(frame), canvas, {objects});
    }

    // 3. Chapter 13's edges, before chapter 09's grain, which has none. Two pictures in one have no motion to follow.
    if (seen || !antialias.method.is("taa"))
        smooth_edges(frame, {view, frame.depth, seen, reel.alone() ? reel.alone()->drawings() : Drawings()});
    post.record(frame, frame.hdr);

    // 4. Titles, and linear light encoded as sRGB.
    reel.record_titles(frame, frame.hdr, time_s);
    encode_srgb(frame);
}
// [/frame]

// The filter's picture, or a share of it.
void Ambiance::smooth_edges(Frame& frame, const Seen& seen) {
    if (smoothed <= 0) return;
    const bool whole = smoothed >= 1 || !(antialias.is_filter() || antialias.method.is("taa"));
    if (!whole)
        frame.compute("keep edges", {.reads = {frame.hdr}, .writes = {jagged_}}, [&](Compute& pass) {
            pass.use(copy_).set("from", frame.hdr, nearest_clamp).set("into", jagged_);
            pass.dispatch_threads(frame.size);
        });
    antialias.record(frame, frame.hdr, seen);
    if (!whole)
        frame.compute("share of edges", {.reads = {jagged_, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(mix_).set("before", jagged_, nearest_clamp).set("picture", frame.hdr);
            pass.set("share", float(smoothed)).dispatch_threads(frame.size);
        });
}

// Effects that the film's tracks switch on, each drawn once: small, since pipelines hold for every size, and by an instance
// of its own, since another thread draws meanwhile.
void Ambiance::make_effects(Gpu& gpu) const {
    constexpr glm::uvec2 size{64, 36};
    Ambiance unseen;
    const KnobList own = all_knobs(), others = unseen.all_knobs();
    for (size_t i = 0; i < own.size(); ++i) others[i]->set(own[i]->text());
    std::set<double> times_s;
    for (const Track& track : reel.film().knobs)
        for (size_t i = 0; i < track.times_s.size(); ++i) {
            times_s.insert(track.times_s[i]);
            if (i > 0) times_s.insert(0.5 * (track.times_s[i - 1] + track.times_s[i]));
        }
    Titles titles;
    double title_s = 0;
    for (const Title& title : reel.film().titles) title_s = 0.5 * (title.from_s + title.to_s);
    Frame frame(gpu);
    frame.root = &unseen;
    for (const double at_s : times_s) {
        for (const Track& track : reel.film().knobs)
            if (!find_knob(own, track.name).pinned) find_knob(others, track.name).set(track.at(at_s));
        unseen.begin_frame(gpu, size);
        frame.begin(size, static_cast<float>(at_s));
        Canvas canvas(frame.hdr, frame.depth);
        canvas.color(frame);
        canvas.depth(frame);
        if (!unseen.antialias.method.is("taa")) unseen.smooth_edges(frame, {View(), frame.depth});
        unseen.post.record(frame, frame.hdr);
        titles.record(frame, frame.hdr, reel.film(), title_s);
        encode_srgb(frame);
        frame.end();
    }
}

// Over all camera paths of the film: the greatest distance from the line between two keys, in lengths of that line; and the
// largest speed over the smallest, of the path on which that is most.
void Ambiance::measure(Gpu&, glm::uvec2, nlohmann::json& error) {
    double off = 0, speed = 1, jump = 0;
    for (const FilmScene& one : reel.film().scenes) {
        const CameraPath& path = one.camera;
        if (path.keys().size() < 2) continue;
        off = std::max(off, off_the_chord(path.positions(), 64));
        jump = std::max(jump, velocity_jump(path.positions().times_s, [&](double t) { return path.eye(t); }));
        constexpr int steps = 512;
        double slowest = 1e30, fastest = 0;
        const double begin = path.keys().front().time_s, whole = path.keys().back().time_s - begin;
        for (int i = 0; i < steps; ++i) {
            const double step =
                glm::distance(path.eye(begin + whole * i / steps), path.eye(begin + whole * (i + 1) / steps));
            slowest = std::min(slowest, step);
            fastest = std::max(fastest, step);
        }
        if (slowest > 0) speed = std::max(speed, fastest / slowest);
    }
    error["off_chord"] = off;
    error["speed"] = speed;
    error["jump"] = jump;
}

}  // namespace lightwalk
