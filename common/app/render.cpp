#include "common/app/render.h"

#include <algorithm>
#include <ctime>

#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/base/patience.h"

namespace lightwalk {
namespace {

const Pipeline add = compute({.shader = "common/accumulate.comp"});
const Pipeline encode = compute({.shader = "common/encode_srgb.comp"});

// Hammersley points (J. M. Hammersley 1960), centred in their strata.
glm::vec2 shift_of(int sample, int samples) {
    if (samples == 1) return glm::vec2(0.0f);
    float inverse = 0.0f, digit = 0.5f;
    for (int bits = sample; bits; bits >>= 1, digit *= 0.5f) inverse += static_cast<float>(bits & 1) * digit;
    const float half_cell = 0.5f / static_cast<float>(samples);
    return {(static_cast<float>(sample) + 0.5f) / static_cast<float>(samples) - 0.5f, inverse + half_cell - 0.5f};
}

// Permutation for progressive refinement without drift across the pixel; 7 is coprime to powers of two.
int scattered(int sample, int samples) { return 7 * sample % samples; }

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// No later pass reads hdr: the output is what is shown.
void refuse_late(const Frame& frame) {
    const auto into = [](const Image& image) { return [&](const auto& one) { return one.second.image == &image; }; };
    const auto encoded = std::find_if(frame.outputs.rbegin(), frame.outputs.rend(), into(frame.output));
    if (encoded == frame.outputs.rend()) return;
    if (const auto late = std::find_if(frame.outputs.rbegin(), encoded, into(frame.hdr)); late != encoded)
        throw Failure("pass '{}' writes hdr after the output, and is not seen: record it before", late->first);
}

void record_frame(Chapter& chapter, Frame& frame, glm::uvec2 size, float time_s, ReadBack* written) {
    chapter.begin_frame(frame.gpu, size);
    frame.begin(size, time_s);
    const double started_ms = processor_ms();
    try {
        chapter.frame(frame);
        if (frame.output.written_in != frame.number())
            throw Failure("the frame of {} wrote no output: end it with encode_srgb()", chapter.name);
        refuse_late(frame);
        if (written) frame.read_back(frame.output, *written);
    } catch (...) {
        frame.end();
        throw;
    }
    frame.recording_ms = processor_ms() - started_ms;
    frame.end();
}

}  // namespace

void add_times(std::vector<PassTime>& sum, const std::vector<PassTime>& times) {
    for (const PassTime& time : times) {
        const auto same = std::find_if(sum.begin(), sum.end(), [&](const PassTime& t) { return t.name == time.name; });
        same == sum.end() ? sum.push_back(time) : void(same->gpu_ms += time.gpu_ms);
    }
}

void render(Chapter& chapter, Frame& frame, const Picture& picture) {
    const int samples = picture.sample ? picture.sample->y : int(chapter.samples);
    const int first = picture.sample ? picture.sample->x : 0, last = picture.sample ? first + 1 : samples;
    std::vector<PassTime> times;
    chapter.prepare_frame(frame.gpu, picture.size, picture.time_s);
    const Accumulation accumulation = chapter.longest_accumulation();
    const int gathered = accumulation.frames > 0 ? picture.gathered.value_or(accumulation.frames) : 0;
    Patience patience("drawing", "samples");
    for (int sample = first; sample < last; ++sample) {
        frame.root = &chapter;
        frame.samples = {sample, samples};
        frame.seed = picture.seed;
        const int point = picture.sample ? scattered(sample, samples) : sample;
        frame.crop = picture.crop;
        if (frame.crop.whole == glm::uvec2(0)) frame.crop.whole = picture.size;
        if (gathered > 0) chapter.forget_history();
        if (gathered > 0 || accumulation.frames == 0) frame.gathered = 0;
        for (int before = std::max(gathered, 1) - 1; before >= 0; --before) {
            // Sub-frames continue the jitter sequence.
            frame.crop.shift = accumulation.frames > 0 ? accumulation.shift(frame.gathered + sample * gathered)
                                                       : shift_of(point, samples);
            const bool is_last = before == 0 && sample + 1 == last;
            record_frame(chapter, frame, picture.size, chapter.gathered_at(picture.time_s, before),
                         is_last ? picture.written : nullptr);
            if (accumulation.frames > 0) ++frame.gathered;
        }
        if (samples > 1) {
            frame.finish();
            add_times(times, frame.times);
        }
        patience.show(sample + 1, samples);
    }
    if (samples > 1) frame.times = std::move(times);
}

ImageRgb render_linear(Chapter& chapter, Gpu& gpu, glm::uvec2 size) {
    Frame frame(gpu);
    render(chapter, frame, {.size = size, .crop = {}});
    return read_linear(gpu, frame.linear());
}

void accumulate(Frame& frame) {
    const auto [sample, samples] = frame.samples;
    if (samples == 1) return;
    const Image& mean = frame.linear();
    frame.compute("accumulate", {.reads = {frame.hdr, mean}, .writes = {mean}}, [&, sample = sample](Compute& pass) {
        pass.use(add).set("hdr", frame.hdr, nearest_clamp).set("mean", mean);
        pass.set("weight", 1.0f / static_cast<float>(sample + 1)).dispatch_threads(frame.size);
    });
}

void encode_srgb(Frame& frame) {
    if (frame.output.written_in == frame.number())
        throw Failure("encode_srgb() writes over the output that this frame has: call it once");
    accumulate(frame);
    frame.compute("encode_srgb", {.reads = {frame.linear()}, .writes = {frame.output}}, [&](Compute& pass) {
        pass.use(encode).set("hdr", frame.linear(), nearest_clamp).set("result", frame.output);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
