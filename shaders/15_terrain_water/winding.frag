// How often the ray upwards from the water leaves a surface, less how often it enters.
layout(location = 0) out float winding;

void main() { winding = gl_FrontFacing ? 1.0 : -1.0; }
