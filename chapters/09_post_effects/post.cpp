#include "09_post_effects/post.h"

#include <cmath>

#include "09_post_effects/adapt_now.h"
#include "common/app/render.h"

namespace lightwalk {

namespace {

constexpr size_t reading_around = 3;  // the first of effects()

// Rows from the top; their order in GLSL's mat3 is kernel[row][column].
glm::mat3 kernel_of(const std::string& name) {
    if (name == "sharpen") return {0, -1, 0, -1, 5, -1, 0, -1, 0};
    if (name == "blur") return glm::mat3(1, 2, 1, 2, 4, 2, 1, 2, 1) / 16.0f;
    if (name == "edges") return {-1, -1, -1, -1, 8, -1, -1, -1, -1};
    return {-2, -1, 0, -1, 1, 1, 0, 1, 2};  // emboss
}

// The part of a turn, in double: after days a float has no digits left for it.
float phase(double turns) { return static_cast<float>(turns - std::floor(turns)); }

}  // namespace

AutoExposure::AutoExposure(Module& owner, std::string name) : Module(owner, std::move(name), "auto_exposure") {}

Post::Post(Module& owner, std::string name) : Module(owner, std::move(name), "post") {}

std::vector<KnobBase*> Post::effects() {
    return {&radial_blur, &aberration, &sharpen,    &exposure,  &white_balance, &tone,
            &contrast,    &brightness, &saturation, &greyscale, &invert,        &vignette,
            &scanlines,   &fade,       &gamma,      &grain,     &dither};
}

// One pass for each effect that reads other pixels, since it needs the finished result before it. The others share a
// pass or have one each. The last pass writes in place, so it reads its own pixel only.
std::vector<Post::Step> Post::steps() {
    std::vector<Step> all;
    const std::vector<KnobBase*> order = effects();
    Step shared;
    for (size_t i = 0; i < order.size() && !method.is("copy"); ++i) {
        if (!is_on(*order[i])) continue;
        if (i < reading_around || method.is("pass_each"))
            all.push_back({order[i]});
        else
            shared.push_back(order[i]);
    }
    const bool last_gathers =
        !all.empty() && std::count(order.begin(), order.begin() + reading_around, all.back()[0]) > 0;
    if (!shared.empty() || last_gathers || method.is("copy")) all.push_back(shared);
    return all;
}

PostNow Post::now(const Frame& frame) const {
    const double time_s = static_cast<double>(frame.time_s);
    const double lines = static_cast<double>(scan_speed.value);
    return {.white = white_balance_matrix(static_cast<double>(white_k.value)),
            .kernel = kernel_of(kernel.text()),
            .mouse = {mouse_x.value, mouse_y.value},
            .whole = glm::vec2(frame.crop.whole == glm::uvec2(0) ? frame.size : frame.crop.whole),
            .origin = glm::vec2(frame.crop.origin),
            .tone_gain = match ? static_cast<float>(matching_gain(tone.text())) : 1.0f,
            .scan_phase = phase(lines * time_s),
            .grain_frame = static_cast<uint32_t>(std::floor(time_s * 24.0)),
            .shown_frame = static_cast<uint32_t>(frame.samples.index),
            .zero = 0};
}

void Post::set_up(Frame& frame, glm::uvec2 size, size_t images) {
    const VkFormat format = store.is("float") ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT;
    between_.resize(std::min<size_t>(images, 2));
    for (Image& image : between_) {
        const Image::Desc desc{.name = path() + " between", .format = format, .size = size};
        image.ensure(frame.gpu.device, desc);
    }
    if (dither.is("blue_noise") && !blue_noise_) blue_noise_ = upload_tile(frame.gpu, "blue noise", blue_noise(64));
    if (grain.is("texture") && !grain_tile_) grain_tile_ = upload_tile(frame.gpu, "grain", film_clumps(256));
}

std::vector<Resource> Post::reads() const {
    std::vector<Resource> all;
    if (exposure.is("automatic")) all.emplace_back(automatic.stops());
    return all;
}

void Post::bind(Pass& pass) const {
    if (exposure.is("automatic")) pass.set_if_present("adapted", automatic.stops(), nearest_clamp);
    if (blue_noise_) pass.set_if_present("blue_noise", blue_noise_, nearest_clamp);
    if (grain_tile_) pass.set_if_present("grain_tile", grain_tile_, nearest_clamp);
}

void Post::run(Frame& frame, const Step& step, const Image& from, const Image& into) {
    const std::vector<KnobBase*> order = effects();
    const bool gathers = !step.empty() && std::count(order.begin(), order.begin() + reading_around, step[0]) > 0;
    const bool in_place = &from == &into;
    const bool full_floats = into.desc.format == VK_FORMAT_R32G32B32A32_SFLOAT;
    const auto is_off = [&](const KnobBase* effect) { return std::count(step.begin(), step.end(), effect) == 0; };
    uint64_t key = 2 * in_place + full_floats;
    for (const KnobBase* effect : order) key = 2 * key + is_off(effect);
    const auto [known, is_new] = variants_.try_emplace(key);
    Macros& variant = known->second;
    if (is_new) {
        for (const KnobBase* effect : order)
            if (is_off(effect)) variant.set(effect->macro(), "0");
        if (in_place) variant.set("IN_PLACE", "1");
        if (full_floats) variant.set("FULL_FLOATS", "1");
    }
    const std::string name = step.size() == 1 && (gathers || method.is("pass_each")) ? step[0]->path() : path();
    frame.compute(name, {.reads = {from, into}, .writes = {into}, .with = {*this}}, [&](Compute& pass) {
        pass.use(gathers ? gather_ : stack_, variant).set("into", into).set("post_now", now(frame));
        if (!in_place) pass.set("from", from, linear_clamp);
        pass.dispatch_threads(into.desc.size);
    });
}

void Post::record(Frame& frame, const Image& picture) {
    const std::vector<Step> all = steps();
    if (!tone.is("off") && !method.is("copy")) frame.apply_tones(path(), picture);
    set_up(frame, picture.desc.size, all.empty() ? 0 : all.size() - 1);
    if (exposure.is("automatic")) automatic.record(frame, picture);
    const Image* from = &picture;
    for (size_t i = 0; i < all.size(); ++i) {
        const Image& into = i + 1 == all.size() ? picture : between_[i % 2];
        run(frame, all[i], *from, into);
        from = &into;
    }
}

void AutoExposure::record(Frame& frame, const Image& hdr) {
    if (!bins_) bins_ = Buffer(frame.gpu.device, {.name = path() + " bins", .bytes = 256 * sizeof(uint32_t)});
    const float passed_s = frame.time_s - std::exchange(last_s_, frame.time_s);
    const bool follows = stops_.valid() && passed_s > 0.0f && adapt_s > 0.0f;
    const Image &before = stops_.before(), &now = stops_.now();
    frame.compute(
        "histogram", {.reads = {hdr, bins_, before}, .writes = {bins_, now}, .with = {*this}}, [&](Compute& pass) {
            pass.use(clear_).set("words", bins_).dispatch_threads({256u, 1u}).wait();
            pass.use(count_).set("picture_bins", bins_).set("hdr", hdr, nearest_clamp);
            pass.dispatch_threads(hdr.desc.size).wait();
            pass.use(adapt_).set("picture_bins", bins_).set("before", before, nearest_clamp);
            pass.set("adapt_now",
                     AdaptNow{.share = follows ? 1.0f - std::exp(-passed_s / adapt_s) : 1.0f, .valid = stops_.valid()});
            pass.set("now", now).dispatch({1, 1, 1});
        });
    shown_ = &now;
}

static const Pipeline film = compute({.shader = "09_post_effects/film.comp"});

void encode_film(Frame& frame) {
    frame.apply_tones("encode_film", frame.hdr);
    accumulate(frame);
    frame.compute("film", {.reads = {frame.linear()}, .writes = {frame.output}}, [&](Compute& pass) {
        pass.use(film).set("hdr", frame.linear(), nearest_clamp).set("result", frame.output);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
