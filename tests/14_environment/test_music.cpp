// Music: files that are read or refused, and levels against double precision.
#include <fmt/core.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "../catch.h"
#include "14_environment/exercises.h"
#include "14_environment/spectrum.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/scene.h"
#include "music_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("lightwalk_music_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::string write(const std::string& name, const std::string& bytes) const {
        write_file(path / name, bytes);
        return (path / name).string();
    }
};

std::string refusal(const std::string& file) {
    try {
        read_sound(file);
        return "it was read";
    } catch (const InputError& error) { return error.what(); }
}

// Where a page begins, from the second page after the headers on.
size_t page_after(const std::string& bytes, size_t at) { return bytes.find("OggS", at + 1); }

Sound piece() {  // a bass, a chord and a hiss that come and go
    uint32_t state = 1;
    return made(44100, 2.5, [&](double t) {
        state = state * 1664525u + 1013904223u;
        const double noise = double(state >> 8) / (1 << 24) - 0.5;
        return 0.4 * tone(55, t) * (std::fmod(t, 0.5) < 0.2) + 0.2 * (tone(440, t) + tone(1300, t)) * std::exp(-t) +
               0.3 * noise * (std::fmod(t, 0.25) < 0.04);
    });
}

Sound noise_and_tone(double seconds) {  // many bytes, and so many pages
    uint32_t state = 7;
    return made(22050, seconds, [&](double t) {
        state = state * 1664525u + 1013904223u;
        return 0.3 * tone(300, t) + 0.5 * (double(state >> 8) / (1 << 24) - 0.5);
    });
}

}  // namespace

TEST_CASE("a file's samples come back as the mean of its channels, at its own rate and length") {
    const Folder folder;
    for (const auto& [rate, count, channels] :
         {std::tuple{44100, 30001, 1}, {48000, 12345, 2}, {8000, 9001, 2}, {22050, 777, 1}, {96000, 5000, 2}}) {
        INFO(rate << " Hz, " << count << " samples, " << channels << " channels");
        const Sound wanted = made(rate, (count + 0.5) / rate, [](double t) { return 0.4 * tone(500, t); });
        std::vector<std::vector<float>> given(size_t(channels), wanted.samples);
        if (channels == 2)  // part that cancels on average
            for (size_t i = 0; i < given[0].size(); ++i) {
                const auto side = static_cast<float>(0.2 * tone(900, double(i) / rate));
                given[0][i] += side;
                given[1][i] -= side;
            }
        const Sound found = read_sound(folder.write("sound.ogg", encoded(rate, given)));
        CHECK(found.rate_hz == rate);
        REQUIRE(found.samples.size() == size_t(count));
        double error = 0, signal = 0;
        for (size_t i = 0; i < found.samples.size(); ++i) {
            error += std::pow(double(found.samples[i]) - double(wanted.samples[i]), 2);
            signal += std::pow(double(wanted.samples[i]), 2);
        }
        CHECK(std::sqrt(error / signal) < 0.06);  // Vorbis is lossy
    }
}

TEST_CASE("a file that is no whole piece of music is refused in words", "[14.whole_file]") {
    using Catch::Matchers::Contains;
    const Folder folder;
    const std::string whole = encoded(22050, {noise_and_tone(6).samples});
    REQUIRE(read_sound(folder.write("whole.ogg", whole)).duration_s() == 6);

    CHECK_THAT(refusal((folder.path / "none.ogg").string()), Contains("none.ogg: cannot be opened: No such file"));
    CHECK_THAT(refusal(folder.path.string()), Contains("is a folder, expected a file"));
    CHECK_THAT(refusal(folder.write("empty.ogg", "")), Contains("empty.ogg: is not sound; expected Ogg Vorbis"));
    CHECK_THAT(refusal(folder.write("text.ogg", std::string(9000, 'x'))), Contains("is not sound"));
    CHECK_THAT(refusal(folder.write("wave.ogg", "RIFF\x24\x08\x00\x00WAVEfmt ")), Contains("is not sound"));

    // Cut: within a page, between two pages, within the headers.
    CHECK_THAT(refusal(folder.write("cut.ogg", whole.substr(0, whole.size() * 2 / 3))),
               Contains("cut.ogg: ends in the middle, after ") && Contains(" s: the file is incomplete"));
    size_t page = page_after(whole, whole.size() / 2);
    REQUIRE(page != std::string::npos);
    CHECK_THAT(refusal(folder.write("pages.ogg", whole.substr(0, page))), Contains("ends in the middle"));
    CHECK_THAT(refusal(folder.write("head.ogg", whole.substr(0, 1000))), Contains("ends before its sound begins"));
    CHECK_THAT(refusal(folder.write("first.ogg", whole.substr(0, 40))), Contains("incomplete"));

    // A page that is missing, and one that is overwritten.
    const size_t next = page_after(whole, page_after(whole, whole.size() / 3));
    const size_t after = page_after(whole, next);
    REQUIRE(after != std::string::npos);
    std::string hole = whole;
    hole.erase(next, after - next);
    CHECK_THAT(refusal(folder.write("hole.ogg", hole)), Contains("hole.ogg: is damaged at "));
    std::string noise = whole;
    for (size_t i = next + 100; i < next + 200; ++i) noise[i] = char(~noise[i]);
    CHECK_THAT(refusal(folder.write("noise.ogg", noise)), Contains("is damaged at "));

    // Two pieces one after the other, which Ogg allows: of one rate they are one sound.
    const std::string other = encoded(44100, {std::vector<float>(20000, 0.0f)}, 2);
    const std::string same = encoded(22050, {std::vector<float>(20000, 0.0f)}, 2);
    CHECK(read_sound(folder.write("two.ogg", whole + same)).samples.size() == 6 * 22050 + 20000);
    CHECK_THAT(refusal(folder.write("rates.ogg", whole + other)), Contains("from 22050 to 44100 samples per second"));
    CHECK_THAT(refusal(folder.write("slow.ogg", encoded(4000, {std::vector<float>(9000, 0.0f)}))),
               Contains("has 4000 samples per second; expected 8000 to 192000"));
    CHECK_THAT(refusal(folder.write("long.ogg", encoded(8000, {std::vector<float>(8000 * 601, 0.0f)}))),
               Contains("long.ogg: lasts 601.0 s; at most 600 s are read"));
}

TEST_CASE("a scene that is written keeps its music") {
    const Folder folder;
    SceneFile scene;
    scene.music.file = "audio/beat.ogg";
    write_scene(scene, folder.path / "out.json");
    CHECK(read_scene(folder.path / "out.json").music.file == "audio/beat.ogg");
}

TEST_CASE("the table's levels are those of a direct double-precision transform of the same samples, to 1e-4") {
    for (const int rate : {8000, 44100, 96000}) {
        Sound sound = piece();
        sound.rate_hz = rate;  // the same samples, played slower or faster
        const LevelTable table = measure_levels(sound);
        double worst = 0;
        for (size_t i = 0; i < table.entries.size(); i += table.entries.size() / 12) {
            const glm::dvec3 exact = truth::spectrum_bands(around(sound, double(i) * LevelTable::hop_s), rate);
            for (int band = 0; band < 3; ++band)
                worst = std::max(worst,
                                 std::abs(double(table.entries[i][band]) - exact[band]) / std::max(exact[band], 1e-3));
        }
        INFO(rate);
        CHECK(worst < 1e-4);
    }
}

TEST_CASE("silence has levels of 0, and music that ends comes to rest") {
    const Sound silence{.rate_hz = 48000, .samples = std::vector<float>(48000)};
    CHECK(measure_levels(silence).most() == Levels(0.0f));
    struct Owner : Module {
    } owner;
    Music music{owner, "music"};
    CHECK(music.levels(0.5) == Levels(0.0f));  // none at all
    music.take(silence);
    for (const double t : {-1.0, 0.0, 0.31, 0.99, 5.0}) CHECK(music.levels(t) == Levels(0.0f));

    music.take(made(48000, 1, [](double t) { return tone(100, t); }));
    CHECK(music.levels(0.5).x > 0.99f);
    float before = music.levels(1.0).x;
    for (double t = 1.02; t < 3; t += 0.02) {  // falls all the time, and is 0 in the end
        const float now = music.levels(t).x;
        CHECK((now < before || now == 0.0f));
        before = now;
    }
    CHECK(music.levels(3.0) == Levels(0.0f));
    CHECK(music.levels(1e9) == Levels(0.0f));
    CHECK(music.levels(-0.01) == Levels(0.0f));
    CHECK(music.levels(std::nan("")) == Levels(0.0f));
}

TEST_CASE("one tone lands in its band") {
    for (const auto& [frequency, band] :
         {std::pair{60.0, 0}, {120.0, 0}, {400.0, 1}, {3000.0, 1}, {5000.0, 2}, {15000.0, 2}}) {
        const LevelTable table = measure_levels(made(44100, 1, [&](double t) { return 0.5 * tone(frequency, t); }));
        const Levels level = table.at(0.5);
        INFO(frequency << " Hz");
        for (int other = 0; other < 3; ++other)
            if (other != band) CHECK(level[other] < 4e-3f * level[band]);  // 400 Hz is 7 bins from the low band
        CHECK(level.w == Approx(0.5 / std::sqrt(2.0)).epsilon(1e-3));
        // 0.5 and both neighbours, spread over the band's bins.
        const double bins = std::array{11.0, 174.0, 743.0}[size_t(band)];
        CHECK(level[band] == Approx(0.5 * std::sqrt(1.5 / bins)).epsilon(2e-3));
    }
}

TEST_CASE("a click has one spectrum everywhere: all bands the same, as long as the window sees it") {
    Sound click{.rate_hz = 44100, .samples = std::vector<float>(44100)};
    click.samples[22050] = 1;
    const LevelTable table = measure_levels(click);
    const Levels middle = table.at(0.5);
    CHECK(middle.x == Approx(1.0 / 512).epsilon(1e-4));  // the window is 1 there
    CHECK(middle.y == Approx(middle.x).epsilon(1e-4));
    CHECK(middle.z == Approx(middle.x).epsilon(1e-4));
    for (const double t : {0.47, 0.53}) CHECK(table.at(t) == Levels(0.0f));

    const LevelTable smooth = smooth_levels(table, 0.0, 0.1);
    CHECK(smooth.at(0.5) == middle);
    CHECK(smooth.at(0.52 + 0.1).x == Approx(smooth.at(0.52).x * std::exp(-1.0)).epsilon(0.01));
}

TEST_CASE("levels are a function of time alone: any order of asking, and a change of the constants and back") {
    struct Owner : Module {
    } owner;
    Music music{owner, "music"}, again{owner, "again"};
    music.take(piece());
    again.take(piece());
    std::vector<Levels> forward;
    for (int i = 0; i < 200; ++i) forward.push_back(music.levels(i / 60.0));
    again.release_ms.value = 400;
    CHECK(again.levels(1.0) != forward[60]);
    again.release_ms.value = music.release_ms;
    for (int i = 200; i-- > 0;) CHECK(again.levels(i / 60.0) == forward[size_t(i)]);
    for (const Levels& level : forward)
        for (int i = 0; i < 4; ++i) CHECK((level[i] >= 0.0f && level[i] <= 1.0f));
    music.plays.value = false;
    CHECK(music.levels(1.0) == Levels(0.0f));
    CHECK(music.sound() == nullptr);
}

TEST_CASE("a spectrum needs an even number of samples") {
    CHECK_THROWS_AS(spectrum_of(std::vector<float>(7)), Failure);
    CHECK_THROWS_AS(spectrum_of({}), Failure);
    const auto bins = spectrum_of(std::vector<float>{1, 2, 3, 4, 5, 6});
    REQUIRE(bins.size() == 4);
    CHECK(bins[0].real() == Approx(21));
    CHECK(bins[3].real() == Approx(-3));
}
