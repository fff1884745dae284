// How far above a surface rays have to begin that do not meet it again: as a power of two times the scene's farthest
// coordinate, the least of which no ray does.
#include "05_shadow_maps/rays.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 0) out vec4 color;
layout(scalar) uniform FarthestBlock { float farthest_m; };

bool meets_itself(vec3 origin, vec3 normal) {
    vec3 x, y;
    basis_of(normal, x, y);
    for (int i = 0; i < 24; ++i) {
        float around = 0.7853982 * float(i % 8);
        float rise = i < 8 ? 0.01 : i < 16 ? 0.2 : 1.0;  // from grazing to steep
        vec3 direction = cos(around) * x + sin(around) * y + rise * normal;
        if (any_hit(Ray(origin, 0.0, direction, on_and_on))) return true;
    }
    return false;
}

void main() {
    vec3 normal = normalize(world_normal);
    int power = -30;
    while (power < -8 && meets_itself(world_position + exp2(float(power)) * farthest_m * normal, normal)) ++power;
    float at_offset = float(meets_itself(above(world_position, normal), normal));
    color = vec4(-float(power), at_offset, 1.0, 1.0);
}
