// For 13.lab_distance: CIE XYZ of linear light with Rec. 709 primaries, over that of its white (D65), which is (1, 1, 1).
// IEC 61966-2-1, its rows divided by the white's X, Y and Z.
vec3 xyz_over_white(vec3 light) {
    return light * mat3(0.433953, 0.376219, 0.189828,
                        0.212673, 0.715152, 0.072175,
                        0.017757, 0.109469, 0.872774);
}
