// Exercise 05.choose_cascades: choose and defend: memory for three shadow maps of a sun.
// Starter: one large map for every scene.

// [choose_cascades]
// The sun's shadow map is cut into cascades. Cascade i reaches from split i to split i + 1, the
// lesson's distances, and its texels are as wide as its far end needs: a texel, seen at a depth of
// d, is split(i + 1) / d * 1080 / size pixels wide in a picture of 1,080 lines.
//
// `scene` is one of three:
// - 0: a cellar, 0.1 m to 100 m, and things to see from 0.1 m on;
// - 1: a valley, 1 m to 2,000 m, and nothing to see nearer than 50 m;
// - 2: a room, 1 m to 20 m, and things to see from 1 m on.
//
// Returns the number of cascades (1 to 4), the size of each (512, 1024, 2048 or 4096 texels), and
// lambda in percent (0 to 100). A texel takes 4 bytes.
//
// Limits: the cellar may take 16 MiB, the valley 16 MiB, the room 8 MiB. The widest texel that is
// seen may be 8 pixels in the cellar, 4 in the valley, 5 in the room. The check measures both and
// prints them.
// [/choose_cascades]
ivec3 choose_cascades(int scene) {
    return ivec3(1, 4096, 50);
}
