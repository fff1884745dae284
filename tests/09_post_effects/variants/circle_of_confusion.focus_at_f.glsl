// wrong: circle_of_confusion(z = 
float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, float height_px, float most_px) {
    float f = focus_m < focal_m ? 1.01 * focal_m : max(focus_m, 1.0001 * focal_m);
    float disc_m = focal_m / f_number * (1.0 - f / z) * focal_m / (f - focal_m);  // z may be infinite
    return clamp(disc_m / sensor_m * height_px, -most_px, most_px);
}
