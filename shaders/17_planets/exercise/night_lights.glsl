// Exercise 17.night_lights: the cities of the night side.
// As it stands they shine by 1 - n·l: most of the day, too.

// [night_lights]
// `city` is the radiance of a place's lamps by night, `cosine` is n·l there, -1 to 1, and `cloud` the opacity of the clouds
// above, 0 to 1. Returns what leaves towards the camera. By day, n·l >= 0, exactly nothing: 1 - n·l would leave half of it
// where the sun is 30° high. Lamps go on during twilight: s²(3 - 2s) with s = -n·l / 0.12 held to 0 to 1, so that all of
// them burn where the sun is 7° below the horizon. Clouds absorb a share `cloud`. Of these three, multiply.
// [/night_lights]
vec3 night_lights(vec3 city, float cosine, float cloud) {
    return city * (1.0 - cosine);
}
