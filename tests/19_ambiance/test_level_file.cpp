// The music's levels as an asset, and how long a state that follows must be warmed up.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "../common/file_fixture.h"
#include "14_environment/music.h"
#include "19_ambiance/reel.h"
#include "common/base/error.h"
#include "common/base/files.h"

using namespace lightwalk;

namespace {

double difference(Levels a, Levels b) {
    double most = 0;
    for (int i = 0; i < 4; ++i) most = std::max(most, double(std::abs(a[i] - b[i])));
    return most;
}

}  // namespace

TEST_CASE("the film's levels are those of its music, within 16 bits: a decoder's last bits move nothing") {
    const std::filesystem::path music = find_asset("audio/ambiance.ogg");
    const LevelTable kept = read_levels(levels_of(music));
    Sound sound = read_sound(music);
    CHECK(double(kept.entries.size()) * LevelTable::hop_s == Approx(sound.duration_s()).margin(0.05));

    // Ten seconds of it, as another decoder may give them; levels are shares of the whole piece's largest.
    sound.samples.resize(size_t(10) * size_t(sound.rate_hz));
    for (size_t i = 0; i < sound.samples.size(); i += 3) sound.samples[i] += 1.0f / (1 << 20);
    const LevelTable measured = measure_levels(sound);
    for (int i = 0; i < 4; ++i) {
        double loudest_s = 1;
        for (double time_s = 1; time_s < 9; time_s += 0.125)
            if (measured.at(time_s)[i] > measured.at(loudest_s)[i]) loudest_s = time_s;
        REQUIRE(measured.at(loudest_s)[i] > 0);
        const double scale = double(kept.at(loudest_s)[i]) / double(measured.at(loudest_s)[i]);
        for (double time_s = 1; time_s < 9; time_s += 0.37)
            REQUIRE(double(kept.at(time_s)[i]) ==
                    Approx(scale * double(measured.at(time_s)[i])).margin(2e-3 * double(kept.at(loudest_s)[i]) + 1e-4));
    }
}

TEST_CASE("levels come back from their file to half of a code of 16 bits") {
    const FileFolder folder;
    const std::filesystem::path music = folder / "music.ogg";
    std::filesystem::copy_file(find_asset("audio/beat.ogg"), music);
    write_levels(music);
    const LevelTable measured = measure_levels(read_sound(music)), kept = read_levels(levels_of(music));
    REQUIRE(kept.entries.size() == measured.entries.size());
    const Levels most = measured.most();
    double off = 0, same = 0;
    for (size_t i = 0; i < kept.entries.size(); ++i)
        for (int k = 0; k < 4; ++k) {
            off =
                std::max(off, std::fabs(double(kept.entries[i][k]) - double(measured.entries[i][k])) / double(most[k]));
            same = std::max(same, double(kept.entries[i][k]) / double(most[k]));
        }
    CHECK(off < 0.51 / 65535);
    CHECK(same == Approx(1));
}

TEST_CASE("a level that follows: begun five time constants before, 0.7% of what was before is left") {
    LevelTable steps;
    for (int i = 0; i < 1280; ++i) steps.entries.push_back(Levels(i < 320 ? 1.0f : 0.25f));
    const double release_s = 0.5, at_s = 5 * release_s + 320 * LevelTable::hop_s;
    const LevelTable whole = smooth_levels(steps, 0, release_s);
    LevelTable late;  // as a machine has it that begins there
    late.entries.assign(steps.entries.begin() + 320, steps.entries.end());
    const LevelTable warmed = smooth_levels(late, 0, release_s);
    const double left = difference(whole.at(at_s), warmed.at(at_s - 320 * LevelTable::hop_s)) / 0.75;
    CHECK(left == Approx(0.0067).epsilon(0.1));
    CHECK(difference(whole.at(at_s - 4 * release_s), warmed.at(at_s - 4 * release_s - 320 * LevelTable::hop_s)) > 0.2);
}
