// wrong: expected 1
float compare_depth(vec3 place, float stored) { return place.z >= stored ? 1.0 : 0.0; }
