// Exercise 09.circle_of_confusion: how wide a point becomes that is not in focus.
// Until you fill it in, all is in focus.

// [circle_of_confusion]
// The diameter of the disc that a point becomes on the sensor, in pixels: below 0 in front of the focus, above 0 behind it. A thin
// lens of focal length F (focal_m) and aperture F / f_number, focused at f (focus_m), spreads a point at the distance z over
//     F / f_number * (z - f) / z * F / (f - F)      metres, on a sensor whose height is sensor_m and has height_px pixels.
// z is above 0, and infinite where there is no surface. An f below 1.01 F counts as 1.01 F: no lens focuses nearer. The result is
// at least -most_px and at most most_px (0 to 1000), and never NaN.
// [/circle_of_confusion]
float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, float height_px, float most_px) {
    return 0.0;
}
