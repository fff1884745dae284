// Exercise 14.spectrum_bands: a stretch of music as three numbers.
// Starter: the music is silent, and nothing moves to it.
#include "14_environment/exercises.h"
#include "14_environment/spectrum.h"

namespace lightwalk::exercise {

// [spectrum_bands]
// How strong the low, middle and high frequencies of a piece of sound are, as three levels
// (x: low, y: middle, z: high). `samples` are 2,048 consecutive samples, about -1 to 1,
// taken at `rate_hz` samples per second (8,000 to 192,000).
//
// 1. Multiply sample n by the Hann window w(n) = 1/2 - 1/2 cos(2 pi n / 2048).
// 2. spectrum_of() (14_environment/spectrum.h) of the 2,048 products gives X(0) to X(1024).
//    X(k) belongs to the frequency k rate_hz / 2048.
// 3. The amplitude at k is |X(k)| / 512: the window halves the sum of a tone of amplitude 1,
//    and half of what is left is at a negative frequency. So a tone of amplitude 1 at exactly
//    one of these frequencies has amplitude 1 there.
// 4. A band's level is the root of the mean of the squared amplitudes over the k whose
//    frequency f lies in the band: low 20 <= f < 250, middle 250 <= f < 4000, high 4000 <= f <
//    20000, in Hz. Every such k counts once. It is a mean because the bands have 10, 160 and
//    683 of them at 48,000 samples per second.
//
// Each level must be accurate to 1e-5 plus a ten-thousandth of its value; silence gives 0.
// At 8,000 samples per second the high band has one k, the last.
// [/spectrum_bands]
glm::vec3 spectrum_bands(const std::vector<float>& samples, float rate_hz) {
    (void)samples, (void)rate_hz;
    return glm::vec3(0.0f);
}

}  // namespace lightwalk::exercise
