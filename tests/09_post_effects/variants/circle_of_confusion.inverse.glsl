// right
float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, float height_px, float most_px) {
    float f = max(focus_m, 1.01 * focal_m), aperture = focal_m / f_number;
    float disc = aperture * f * (1.0 / f - 1.0 / z) * focal_m / (f - focal_m);
    return clamp(disc * height_px / sensor_m, -most_px, most_px);
}
