// wrong: NaN
float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, float height_px, float most_px) {
    float f = max(focus_m, 1.01 * focal_m);
    return clamp(focal_m / f_number * (z - f) / z * focal_m / (f - focal_m) / sensor_m * height_px, -most_px, most_px);
}
