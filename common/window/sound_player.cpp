#include "common/window/sound_player.h"

#include <SDL2/SDL.h>
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>

#include "common/window/event_log.h"

namespace lightwalk {
namespace {

constexpr double same_s = 1e-3;    // times that differ by less are no jump: the window's are rounded
constexpr double fade_s = 0.005;   // at a jump, where the samples would click
constexpr double asleep_s = 0.25;  // a device that has asked for nothing for so long has stopped

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

// SDL calls the callback in a thread of its own; shared data is guarded.
struct SoundPlayer::Device {
    // SDL is loaded when it is needed, not with each program: its 40 libraries take 12 ms to load, and most runs draw a
    // picture without a window.
    struct Sdl {
        void* library = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
#define LIGHTWALK_SDL(name) \
    decltype(&::name) name = library ? reinterpret_cast<decltype(&::name)>(dlsym(library, #name)) : nullptr
        LIGHTWALK_SDL(SDL_SetHint);
        LIGHTWALK_SDL(SDL_InitSubSystem);
        LIGHTWALK_SDL(SDL_QuitSubSystem);
        LIGHTWALK_SDL(SDL_OpenAudioDevice);
        LIGHTWALK_SDL(SDL_CloseAudioDevice);
        LIGHTWALK_SDL(SDL_PauseAudioDevice);
        LIGHTWALK_SDL(SDL_GetError);
#undef LIGHTWALK_SDL
        bool whole() const {
            return SDL_SetHint && SDL_InitSubSystem && SDL_QuitSubSystem && SDL_OpenAudioDevice &&
                   SDL_CloseAudioDevice && SDL_PauseAudioDevice && SDL_GetError;
        }
    } sdl;

    SDL_AudioDeviceID id = 0;
    SDL_AudioSpec spec{};
    std::mutex guard;
    std::vector<float> samples;
    int rate_hz = 0;
    double place = 0, jump_to = 0;  ///< in samples of the sound
    double begun_at = 0;            ///< where it was when the device asked for its latest buffer, in samples
    double asked_s = 0;             ///< when that was
    float gain = 0;
    bool plays = false, jumps = false;
    const Sound* copied_from = nullptr;
    const float* copied_data = nullptr;

    std::string open() {
        if (!sdl.library || !sdl.whole()) return "SDL2 is not installed";
        // Or it takes SIGINT and SIGTERM for itself, and the program no longer ends.
        sdl.SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        if (sdl.SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return sdl.SDL_GetError();
        const SDL_AudioSpec wanted{
            .freq = 48000, .format = AUDIO_F32SYS, .channels = 1, .samples = 512, .callback = fill, .userdata = this};
        id = sdl.SDL_OpenAudioDevice(nullptr, 0, &wanted, &spec, 0);
        if (id == 0) return sdl.SDL_GetError();
        sdl.SDL_PauseAudioDevice(id, 0);
        return "";
    }
    ~Device() {
        if (id) sdl.SDL_CloseAudioDevice(id);
        if (sdl.library && sdl.whole()) sdl.SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }

    double step() const { return double(rate_hz) / spec.freq; }  ///< samples of the sound for one of the device's

    /// The sample that is heard. When the device asks for a buffer the one before begins to be heard, as long as it lasts.
    double heard() const {
        const double since = std::min((now_s() - asked_s) * spec.freq, double(spec.samples));
        return begun_at + (since - double(spec.samples)) * step();
    }

    float sample_at(double at) const {
        if (!(at >= 0) || at + 1 >= double(samples.size())) return 0.0f;
        const auto first = static_cast<size_t>(at);
        const auto share = static_cast<float>(at - double(first));
        return samples[first] + share * (samples[first + 1] - samples[first]);
    }

    static void fill(void* self, Uint8* bytes, int size) {
        Device& d = *static_cast<Device*>(self);
        const std::lock_guard lock(d.guard);
        d.asked_s = now_s();
        d.begun_at = d.place;
        float* out = reinterpret_cast<float*>(bytes);
        const auto slope = static_cast<float>(1.0 / (fade_s * d.spec.freq));
        for (int i = 0; i < size / int(sizeof(float)); ++i) {
            d.gain = std::clamp(d.gain + (d.plays && !d.jumps ? slope : -slope), 0.0f, 1.0f);
            if (d.gain == 0.0f && d.jumps) {
                d.place = d.jump_to;
                d.jumps = false;
                d.begun_at = d.place - i * d.step();
            }
            out[i] = d.gain * std::clamp(d.sample_at(d.place), -1.0f, 1.0f);
            if (d.gain > 0.0f) d.place += d.step();
        }
    }
};

SoundPlayer::SoundPlayer() = default;
SoundPlayer::~SoundPlayer() = default;

double SoundPlayer::advance(const Sound* sound, double time_s, bool clock_runs, double since_last_s) {
    if (sound && !tried_) {
        tried_ = true;
        device_ = std::make_unique<Device>();
        if (const std::string why = device_->open(); !why.empty()) {
            device_.reset();
            log_event("no sound: " + why);
            std::fprintf(stderr, "note: the music is not heard: %s\n", why.c_str());
        } else {
            log_event("sound at " + std::to_string(device_->spec.freq) + " Hz");
        }
    }
    const double by_processor_s = clock_runs ? time_s + since_last_s : time_s;
    if (!device_) return by_processor_s;
    Device& d = *device_;
    const std::lock_guard lock(d.guard);
    d.plays = sound && clock_runs;
    const bool goes_on = ran_ && std::abs(time_s - given_s_) < same_s;
    ran_ = d.plays;
    if (!d.plays) return by_processor_s;
    const bool is_new = d.copied_from != sound || d.copied_data != sound->samples.data();
    if (is_new) {
        d.samples = sound->samples;
        d.rate_hz = sound->rate_hz;
        d.copied_from = sound;
        d.copied_data = sound->samples.data();
    }
    if (!goes_on || is_new) {
        d.jump_to = time_s * d.rate_hz;
        d.jumps = true;
        d.asked_s = std::max(d.asked_s, now_s() - asleep_s / 2);  // it gets the time to wake up
    }
    // The count of samples; it never goes back, also where the device begins a buffer late.
    if (now_s() - d.asked_s < asleep_s)
        given_s_ = d.jumps ? time_s : std::max(time_s, d.heard() / d.rate_hz);
    else {
        given_s_ = by_processor_s;
        d.jump_to = given_s_ * d.rate_hz;
        d.jumps = true;
    }
    return given_s_;
}

}  // namespace lightwalk
