// Exercise 17.night_lights: the cities of the night side.
// Starter: they shine by 1 - n·l: most of the day, too.

// [night_lights]
// `city` is the radiance of the lamps at a point by night, `cosine` is n·l there, -1 to 1, and
// `cloud` the opacity of the clouds above, 0 to 1. Returns the radiance towards the camera, the
// product of three factors: `city`; the share of the lamps that burn; and 1 - cloud, since
// clouds absorb the share `cloud`. By day, n·l >= 0, no lamp burns (a share of 1 - n·l would
// leave half of them on where the sun is 30° high). Lamps go on during twilight: their share is
// s²(3 - 2s) with s = -n·l / 0.12, clamped to 0 to 1, so that all of them burn where the sun is
// 7° below the horizon.
// [/night_lights]
vec3 night_lights(vec3 city, float cosine, float cloud) {
    return city * (1.0 - cosine);
}
