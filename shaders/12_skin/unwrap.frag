// Attributes of the surface in a texel of the map.
#include "12_skin/matt_color.glsl"

layout(location = 11) flat in uint chart;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 albedo;

void main() {
    MappedSurface m = map_surface(world_position + world_normal, materials[material_index], coordinates_at(view));
    position = vec4(world_position, 1.0 + float(chart));
    normal = vec4(m.facing, m.substance.mixed.specular.g);
    albedo = vec4(matt_color(m.substance), m.substance.mixed.specular.r);
}
