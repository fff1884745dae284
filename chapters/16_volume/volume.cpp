#include "16_volume/volume.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>

#include "16_volume/exercises.h"
#include "16_volume/volume_data.h"
#include "common/base/bytes.h"
#include "common/base/exercise.h"

namespace lightwalk {

namespace {

constexpr int table_texels = 256;

std::vector<uint64_t> as_halves(const std::vector<glm::vec4>& numbers) {
    std::vector<uint64_t> halves;
    halves.reserve(numbers.size());
    for (const glm::vec4& number : numbers) halves.push_back(glm::packHalf4x16(number));
    return halves;
}

float turn_of(double radians) { return static_cast<float>(std::fmod(radians, glm::two_pi<double>())); }

// From the world, in which a face looks along +z, to a scan's axes: x from left to right of the head, y from back to
// front, z up.
const glm::mat3 to_scan{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}};

}  // namespace

float majorant(const std::vector<glm::vec4>& transfer) {
    float most = 0;
    for (const glm::vec4& looks : transfer) most = std::max(most, looks.a);
    // Textures hold 11 bits of an opacity.
    return std::max(-1.01f * std::log(std::max(1.0f - most, LEAST_TRANSMITTANCE)) / REFERENCE_M, 1e-6f);
}

Volume::Volume(Module& owner, std::string name) : Drawing(owner, std::move(name), "volume") {}

NoiseMoment noise_moment(double cells, int seed) {
    const double skewed = cells * (std::sqrt(5.0) - 1) / 4;
    const double whole = std::floor(cells), skew_whole = std::floor(skewed);
    return {.cell = static_cast<int>(whole),
            .time = static_cast<float>(cells - whole),
            .skew_cell = static_cast<int>(skew_whole),
            .skew_time = static_cast<float>(skewed - skew_whole),
            .seed = seed};
}

void Volume::prepare(Gpu&, Scene& loaded) {
    scene_ = &loaded;
    past_.clear();
    light_made_.forget();
}

VolumeNow Volume::now(const Frame& frame) const {
    const double time_s = static_cast<double>(frame.time_s), turn = time_s * static_cast<double>(wave_speed);
    const Sun sun = scene_->sun();
    const bool near = light_from.is("heart");
    const glm::vec3 size(ImageView(field.density()).size());
    const float samples = method.is("exact") ? static_cast<float>(truth_samples) * std::max({size.x, size.y, size.z})
                                             : static_cast<float>(steps);
    return {.half_m = field.half_m(),
            .radius_m = field.is_file() ? 0.0f : 1.0f,
            .to_volume = field.is_file() ? to_scan : glm::mat3(1.0f),
            .size = size,
            .step_m = 2.0f / samples,
            .light_at = near ? glm::vec3(0.0f) : sun.to_sun,
            .is_near = near ? 1.0f : 0.0f,
            .light = near ? heart.value : sun.light,
            .brightest = brightest,
            .majorant = majorant(transfer_texels_),
            .wave_phase = {turn_of(turn), turn_of(1.31 * turn + 1), turn_of(0.73 * turn + 2)},
            .wave = wave,
            .moment = noise_moment(time_s * static_cast<double>(shell_speed), field.variety)};
}

void Volume::update(Frame& frame) {
    field.record(frame);
    make_transfer(frame);
    now_ = now(frame);
    if (method.is("skipping") || show.is("blocks")) {
        // A wave takes a sample up to 1.5 amplitudes away along each axis.
        const float voxels = 1.5f * wave * std::max({now_.size.x, now_.size.y, now_.size.z});
        pyramid_.record(frame, field, transfer_, transfer_number_, 1 + static_cast<int>(std::ceil(voxels)));
    }
    make_tables(frame);
    if (light.is("volume")) make_light(frame);
}

void Volume::make_transfer(Frame& frame) {
    if (transfer_made_.is_current(transfer.index, density.value)) return;
    ++transfer_number_;
    transfer_texels_ = transfer_function(transfer.text(), density);
    transfer_.ensure(frame.gpu.device,
                     {.name = "transfer function", .size = {static_cast<uint32_t>(TRANSFER_TEXELS), 1}, .kept = true});
    const std::vector<uint64_t> halves = as_halves(transfer_texels_);
    frame.upload("transfer function", transfer_, std::as_bytes(std::span(halves)));
}

void Volume::make_tables(Frame& frame) {
    Device& device = frame.gpu.device;
    if (noise.is("texture") && !noise_) {
        noise_ = Image(device,
                       {.name = "noise", .format = VK_FORMAT_R16_SFLOAT, .size = {32, 32}, .depth = 32, .kept = true});
        frame.compute("noise", {.writes = {noise_}}, [&](Compute& pass) {
            pass.use(make_noise_).set("result", noise_).dispatch_threads(glm::uvec3(32));
        });
    }
    if (!method.is("preintegrated")) return;
    if (preintegrated_made_.is_current(transfer_number_, now_.step_m, Exercises::epoch())) return;
    preintegrated_.ensure(device, {.name = "preintegrated", .size = glm::uvec2(table_texels), .kept = true});
    const std::vector<uint64_t> halves =
        as_halves(preintegrated_table(transfer_texels_, table_texels, now_.step_m / REFERENCE_M));
    frame.upload("preintegrated", preintegrated_, std::as_bytes(std::span(halves)));
}

// Transmittances, or optical depths for scattering, at half the field's resolution; made again in each frame in which
// anything it depends on has changed.
void Volume::make_light(Frame& frame) {
    const glm::uvec3 size = glm::max((ImageView(field.density()).size() + 1u) / 2u, glm::uvec3(1));
    light_.ensure(frame.gpu.device, {.name = "light in the volume",
                                     .format = VK_FORMAT_R16_SFLOAT,
                                     .size = {size.x, size.y},
                                     .depth = size.z,
                                     .kept = true});
    const glm::vec4 waves = wave > 0 ? glm::vec4(now_.wave_phase, now_.wave) : glm::vec4(0.0f);
    if (light_made_.is_current(field.number(), transfer_number_, light_steps.value, now_.light_at, now_.is_near,
                               scattering.is("none"), Exercises::epoch(), waves))
        return;
    frame.compute("light in the volume", {.reads = {field.density(), transfer_}, .writes = {light_}, .with = {*this}},
                  [&](Compute& pass) { pass.use(make_light_).set("result", light_).dispatch_threads(size); });
}

std::vector<Resource> Volume::reads() const { return {field.density()}; }

void Volume::bind(Pass& pass) const {
    pass.set_if_present("volume_field", field.density(), linear_clamp);
    pass.set_if_present("volume_transfer", transfer_, linear_clamp);
    pass.set_if_present("volume_now", now_);
}

int Volume::pictures(uint32_t view) const {
    const auto found = past_.find(view);
    return found == past_.end() ? 0 : found->second.pictures;
}

void Volume::draw(Frame& frame, const View& view, Canvas& canvas) {
    const ImageView color = canvas.color(frame), depth = canvas.depth(frame);
    now_ = now(frame);
    now_.rays = view_rays(view);
    Past& past = past_[view.id];
    if (past.marched.ensure(
            frame.gpu.device,
            {.name = path() + " marched", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = view.size, .kept = true}))
        past.of.clear();
    // The history is that of this very picture: the same view, volume, knobs and objects.
    ByteWriter of;
    of(now_, field.number(), transfer_number_, scene_->epoch, epoch(), frame.seed);
    past.pictures = of.bytes == past.of ? past.pictures : 0;
    past.of = std::move(of.bytes);
    now_.history = static_cast<float>(past.pictures);
    now_.seed =
        65536u * frame.seed + 1024u * static_cast<uint32_t>(frame.samples.index) + static_cast<uint32_t>(past.pictures);
    now_.turn = static_cast<float>(std::fmod(0.6180339887498949 * (past.pictures + frame.samples.index), 1.0));

    ComputeAccess access{
        .reads = {color, depth, transfer_, past.marched}, .writes = {color, past.marched}, .with = {*this}};
    for (const Image* image :
         std::initializer_list<const Image*>{&light_, &preintegrated_, &noise_, &pyramid_.blocks()})
        if (*image) access.reads.emplace_back(*image);
    frame.compute("volume", access, [&](Compute& pass) {
        pass.use(march_).set("result", color).set("depth", depth, nearest_clamp);
        pass.set_if_present("marched", past.marched);
        pass.set_if_present("volume_light", light_, linear_clamp);
        pass.set_if_present("volume_preintegrated", preintegrated_, linear_clamp);
        pass.set_if_present("volume_noise", noise_, linear_repeat);
        pass.set_if_present("volume_blocks", pyramid_.blocks(), nearest_clamp);
        pass.dispatch_threads(view.size);
    });
    if (averages()) ++past.pictures;
}

namespace {

struct Point {
    float density;
    glm::vec3 color;
    float opacity;  ///< of REFERENCE_M metres
};

// Colours above 1 shine. Between two points colour and opacity change evenly.
const std::map<std::string, std::vector<Point>> functions{
    {"nebula",
     {{0.0f, {0.10f, 0.16f, 0.9f}, 0.0f},
      {0.09f, {0.12f, 0.2f, 1.0f}, 0.0f},
      {0.19f, {0.22f, 0.25f, 1.1f}, 0.008f},
      {0.34f, {0.9f, 0.22f, 0.75f}, 0.022f},
      {0.55f, {1.5f, 0.45f, 0.25f}, 0.055f},
      {0.78f, {2.2f, 1.3f, 0.55f}, 0.10f},
      {1.0f, {3.0f, 2.7f, 2.2f}, 0.16f}}},
    {"skin",
     {{0.0f, {0.8f, 0.5f, 0.4f}, 0.0f},
      {0.12f, {0.8f, 0.5f, 0.4f}, 0.0f},
      {0.2f, {0.85f, 0.55f, 0.42f}, 0.55f},
      {0.45f, {0.9f, 0.6f, 0.48f}, 0.8f},
      {1.0f, {0.95f, 0.75f, 0.65f}, 0.9f}}},
    {"inside",
     {{0.0f, {0.8f, 0.4f, 0.3f}, 0.0f},
      {0.10f, {0.8f, 0.4f, 0.3f}, 0.0f},
      {0.16f, {0.9f, 0.42f, 0.3f}, 0.012f},
      {0.30f, {0.9f, 0.35f, 0.25f}, 0.004f},
      {0.44f, {0.95f, 0.8f, 0.6f}, 0.03f},
      {0.56f, {1.0f, 0.92f, 0.78f}, 0.35f},
      {1.0f, {1.0f, 0.97f, 0.9f}, 0.6f}}},
    {"shell",
     {{0.0f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {0.49f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {0.5f, {1.0f, 0.8f, 0.5f}, 0.5f},
      {0.51f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {1.0f, {1.0f, 0.8f, 0.5f}, 0.0f}}},
    {"even", {{0.0f, {1.0f, 1.0f, 1.0f}, 0.0f}, {1.0f, {1.0f, 1.0f, 1.0f}, 0.2f}}}};

}  // namespace

const std::vector<std::string>& transfer_names() {
    static const std::vector<std::string> names{"nebula", "skin", "inside", "shell", "even"};
    return names;
}

std::vector<glm::vec4> transfer_function(const std::string& name, float density) {
    const std::vector<Point>& points = functions.at(name);
    std::vector<glm::vec4> texels;
    for (int i = 0; i < TRANSFER_TEXELS; ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(TRANSFER_TEXELS - 1);
        size_t next = 1;
        while (next + 1 < points.size() && points[next].density < at) ++next;
        const Point &a = points[next - 1], &b = points[next];
        const float share = std::clamp((at - a.density) / (b.density - a.density), 0.0f, 1.0f);
        const float opacity = glm::mix(a.opacity, b.opacity, share);
        texels.emplace_back(glm::mix(a.color, b.color, share), 1.0f - std::pow(1.0f - opacity, density));
    }
    return texels;
}

std::vector<glm::vec4> preintegrated_table(const std::vector<glm::vec4>& transfer, int texels, float ratio) {
    std::vector<glm::vec4> table;
    table.reserve(static_cast<size_t>(texels) * static_cast<size_t>(texels));
    const auto density = [&](int i) { return static_cast<float>(i) / static_cast<float>(texels - 1); };
    for (int back = 0; back < texels; ++back)
        for (int front = 0; front < texels; ++front)
            table.push_back(preintegrate(transfer, density(front), density(back), ratio));
    return table;
}

float thinnest_layer(const std::vector<glm::vec4>& transfer) {
    float thinnest = 1;
    for (size_t peak = 1; peak + 1 < transfer.size(); ++peak) {
        const float top = transfer[peak].a;
        if (top <= 0 || transfer[peak - 1].a > top || transfer[peak + 1].a > top) continue;
        size_t first = peak, last = peak;
        while (first > 0 && transfer[first - 1].a > top / 2) --first;
        while (last + 1 < transfer.size() && transfer[last + 1].a > top / 2) ++last;
        if (first == 0 || last + 1 == transfer.size()) continue;  // it goes on to the end of the range
        thinnest = std::min(thinnest, static_cast<float>(last - first + 1) / static_cast<float>(transfer.size()));
    }
    return thinnest;
}

}  // namespace lightwalk
