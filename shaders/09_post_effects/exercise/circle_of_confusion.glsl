// Exercise 09.circle_of_confusion: diameter of the disc of a point out of focus.
// Starter: everything is in focus.

// [circle_of_confusion]
// Returns the signed diameter of the disc that a point becomes on the sensor, in
// pixels: below 0 in front of the plane of focus, above 0 behind it. A thin lens of
// focal length F (focal_m), focused at f (focus_m), images a point at the distance z as
// a disc of
//
//     F / f_number * (z - f) / z * F / (f - F)
//
// metres. The sensor is sensor_m metres high and has height_px rows of pixels.
//
// z is above 0, and infinite where there is no surface: the disc then has the limit of
// the formula, and infinity / infinity would be NaN. A lens cannot focus arbitrarily
// near: replace f by 1.01 F if it is less, everywhere. The result is limited to
// -most_px ... most_px (most_px is 0 to 1000) and never NaN.
// [/circle_of_confusion]
float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, float height_px, float most_px) {
    return 0.0;
}
