// For the check of 06.screen_box.
#include "06_deferred/screen_box_data.glsl"
#include "06_deferred/screen_box.glsl"
