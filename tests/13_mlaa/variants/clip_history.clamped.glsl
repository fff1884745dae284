// wrong: clip_history(
vec3 clip_history(vec3 history, vec3 lowest, vec3 highest) { return clamp(history, lowest, highest); }
