// Sound beside the picture: the samples given to a device, here SDL's that writes to a file.
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <thread>

#include "catch.h"
#include "common/base/files.h"
#include "common/window/sound_player.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

// Each sample says where it is: -1 at 0 s to 1 at 10 s.
Sound ruler() {
    Sound sound{.rate_hz = 22050};
    for (int i = 0; i < 220500; ++i) sound.samples.push_back(static_cast<float>(i) / 110250.0f - 1.0f);
    return sound;
}

struct ToFile {
    fs::path file = fs::temp_directory_path() / ("lightwalk_sound_" + std::to_string(getpid()) + ".raw");
    ToFile() {
        setenv("SDL_AUDIODRIVER", "disk", 1);
        setenv("SDL_DISKAUDIOFILE", file.c_str(), 1);
    }
    ~ToFile() {
        unsetenv("SDL_AUDIODRIVER");
        unsetenv("SDL_DISKAUDIOFILE");
        fs::remove(file);
    }
    std::vector<float> samples() const {
        const std::string bytes = read_file(file);
        std::vector<float> values(bytes.size() / sizeof(float));
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
        return values;
    }
};

using Clock = std::chrono::steady_clock;

// Frames of 20 ms or, on a busy machine, more; from a time of the chapter on. Returns the time of the last one.
double run(SoundPlayer& player, const Sound* sound, double time_s, int frames, bool clock_runs) {
    const auto start = Clock::now();
    double before = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const double passed = std::chrono::duration<double>(Clock::now() - start).count();
        const double next = player.advance(sound, time_s, clock_runs, passed - before);
        before = passed;
        CHECK(next >= time_s);
        time_s = next;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return time_s;
}

// Whether it holds in one of a few trials: a clock waits where the machine stands still for a moment, which is not each time.
bool holds_once(const std::function<bool()>& trial) {
    for (int i = 0; i < 4; ++i)
        if (trial()) return true;
    return false;
}

double heard_s(float value) { return 5 * (double(value) + 1); }

// Handlers of SIGINT and SIGTERM.
std::vector<void (*)(int)> handlers() {
    std::vector<void (*)(int)> found;
    for (const int ends : {SIGINT, SIGTERM}) {
        struct sigaction action {};
        sigaction(ends, nullptr, &action);
        found.push_back(action.sa_handler);
    }
    return found;
}

}  // namespace

TEST_CASE("the sample of the picture's time is heard; a clock that stands is silent, and one that jumps is followed") {
    const ToFile device;
    const Sound sound = ruler();
    double stopped = 0;
    const auto before = handlers();  // Catch2 has its own
    {
        SoundPlayer player;
        stopped = run(player, &sound, 1.0, 30, true);
        CHECK(run(player, &sound, stopped, 15, false) == stopped);
        run(player, &sound, 7.0, 30, true);
        run(player, nullptr, 0, 10, true);
        CHECK(handlers() == before);  // SDL would replace handlers that end a program
    }
    const std::vector<float> played = device.samples();
    REQUIRE(played.size() > 48000);
    size_t first = 0, last_before = 0, silent = 0, after = 0;
    double steepest = 0;
    for (size_t i = 1; i < played.size(); ++i) {
        steepest = std::max(steepest, std::abs(double(played[i]) - double(played[i - 1])));
        if (played[i] != 0.0f && !first) first = i;
        if (played[i] < -0.3f && heard_s(played[i]) < 4) last_before = i;  // 1 to 1.6 s
        if (played[i] > 0.3f && !after) after = i;                         // 7 s and more, faded in
        silent += last_before && !after && played[i] == 0.0f;
    }
    REQUIRE(first > 0);
    REQUIRE(after > last_before);
    CHECK(steepest < 0.006);       // no click: it fades over 240 samples
    CHECK(silent > 7200);          // while the clock stood
    CHECK(played.back() == 0.0f);  // and at the end
    // At the sound's own speed wherever it neither fades nor is silent, which it also is where the machine stands still.
    int at_its_speed = 0;
    for (size_t i = first + 480; i < last_before; ++i)  // 0.01 s of the 5 s from one integer to the next
        at_its_speed += std::abs(double(played[i]) - double(played[i - 480]) - 0.01 / 5) < 1e-5;
    CHECK(at_its_speed > 4800);
    REQUIRE(played.size() > after + 480);
    CHECK(heard_s(played[after + 480]) == Approx(7.0).margin(0.3));  // faded in
}

TEST_CASE("the picture's clock is the count of the samples played, at the device's speed and not the processor's") {
    setenv("SDL_DISKAUDIODELAY", "32", 1);  // for 512 samples: a third of 48,000 a second
    const Sound sound = ruler();
    double heard = 0, written_s = 0;
    const bool held = holds_once([&] {
        const ToFile device;
        const auto start = Clock::now();
        {
            SoundPlayer player;
            heard = run(player, &sound, 2.0, 75, true) - 2.0;
        }
        const double passed = std::chrono::duration<double>(Clock::now() - start).count();
        const std::vector<float> played = device.samples();
        size_t first = 0;
        while (first < played.size() && played[first] == 0.0f) ++first;
        written_s = double(played.size() - first) / 48000;
        return heard < passed / 2 && std::abs(heard - written_s) < 0.06;
    });
    INFO(heard << " s heard, " << written_s << " s written");
    CHECK(held);
    unsetenv("SDL_DISKAUDIODELAY");
}

TEST_CASE("a dummy device plays at its own speed; without a device the processor's clock counts") {
    const Sound sound = ruler();
    for (const char* driver : {"dummy", "none_of_that_name"}) {
        INFO(driver);
        setenv("SDL_AUDIODRIVER", driver, 1);
        SoundPlayer player;
        CHECK(holds_once([&] {
            const auto start = Clock::now();
            const double time_s = run(player, &sound, 3.0, 40, true);
            return std::abs(time_s - 3.0 - std::chrono::duration<double>(Clock::now() - start).count()) < 0.15;
        }));
        CHECK(player.advance(&sound, 8.0, true, 0.02) == Approx(8.0).margin(0.03));    // set: it goes on from there
        CHECK(player.advance(nullptr, 9.0, true, 0.02) == Approx(9.02).margin(1e-6));  // nothing to hear
        unsetenv("SDL_AUDIODRIVER");
    }
}
