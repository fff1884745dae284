// Point lamps. Chapter 04 replaces this file with lamps of finite size.

bool is_above(vec3 facing, uint light, vec3 position, vec3 to_light) { return dot(facing, to_light) > 0.0; }

Reflected reflect_lamp(Surface surface, uint light, vec3 position, vec3 to_light) { return reflect_light(surface, to_light); }
