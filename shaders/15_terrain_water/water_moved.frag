// Motion vectors of water.
#include "13_mlaa/put_motion.glsl"
#include "15_terrain_water/water_surface.glsl"
#include "15_terrain_water/waterline.glsl"
#include "common/structs.h"

layout(location = 0) in vec2 at_rest;
layout(location = 1) in vec3 position;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform FromToBlock { mat4 now, before; } from_to;  // without the shifts within a pixel
layout(scalar) uniform WaterBeforeBlock { WaterBefore water_before; };
uniform sampler2DArray ocean_moved_before;

const float least_slope = 0.003;  // smaller ones change no light that one sees

// Least squares of all waves.
struct Travel {
    OceanTravel sums;
    float slopes;  // sum of slope²
};

// How far a wave's phase has turned, in radians.
float turn_of(float now, float before) { return mod(now - before + 3.14159265, 6.2831853) - 3.14159265; }

void add_wave(inout Travel travel, vec2 k, float slope, float turn) {
    float square = slope * slope;
    travel.sums.squares += square * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
    travel.sums.turned += square * turn * k;
    travel.sums.changed += square * turn * turn;
    travel.slopes += square;
}

// Metres by which the slopes have travelled, as one pattern. Light follows slopes, and slopes travel with the waves, while the
// water circles in place. Waves travel at different speeds; this is the motion that leaves the least change of slope. z: what
// it leaves, as a share of the slopes.
vec3 travelled(vec2 at, vec2 moved, float spacing) {
    Travel travel = Travel(OceanTravel(vec3(0.0), vec2(0.0), 0.0), 0.0);
#if WATER_METHOD == WATER_METHOD_SINES || WATER_METHOD == WATER_METHOD_GERSTNER
    for (uint i = 0u; i < min(water_now.waves, water_before.waves); ++i) {
        WaveData w = water_now.wave[i];
        float size = length(w.k);
        add_wave(travel, w.k, size * w.amplitude * drawn_share(6.2831853 / size, spacing), turn_of(w.phase, water_before.wave[i].phase));
    }
#elif WATER_METHOD == WATER_METHOD_FFT
    for (int i = 0; i < 3; ++i) {
        float share = drawn_share(water_now.cut_m[i], spacing), square = share * share;
        travel.sums.squares += square * water_before.ocean[i].squares;
        travel.sums.turned += square * water_before.ocean[i].turned;
        travel.sums.changed += square * water_before.ocean[i].changed;
        travel.slopes += square * water_now.hidden[i];
    }
#endif
#if WATERLINE_METHOD == WATERLINE_METHOD_RINGS
    vec3 from = from_waterline(at + moved);
    for (int i = 0; i < RING_WAVES; ++i)
        add_wave(travel, 6.2831853 / ring_length(i) * from.yz, ring_steepness(i, from, spacing), turn_of(waterline_map.phase[i], water_before.ring_phase[i]));
#endif
    if (travel.slopes < least_slope * least_slope) return vec3(0.0);
    vec3 m = travel.sums.squares;
    m.xz += 5e-4 * (m.x + m.z);  // one wave has no motion along its crest
    vec2 b = travel.sums.turned, way = vec2(m.z * b.x - m.y * b.y, m.x * b.y - m.y * b.x) / (m.x * m.z - m.y * m.y);
    return vec3(way, sqrt(max(travel.sums.changed - dot(way, b), 0.0) / travel.slopes));
}

vec3 moved_before(vec2 at, float spacing) {
    vec3 sum = vec3(0.0);
#if WATER_METHOD == WATER_METHOD_SINES || WATER_METHOD == WATER_METHOD_GERSTNER
    for (uint i = 0u; i < water_before.waves; ++i) {
        WaveData w = water_before.wave[i];
        sum += gerstner(at, w.k, drawn_share(6.2831853 / length(w.k), spacing) * w.amplitude, w.steepness, w.phase);
    }
#elif WATER_METHOD == WATER_METHOD_FFT
    for (int i = 0; i < 3; ++i) sum += ocean_point(ocean_moved_before, at, i, spacing).xyz;
#endif
    return sum;
}

void main() {
    float radius = length(at_rest - water_now.center), drawn = ring_spacing(radius);
    float seen = 0.5 * max(length(dFdx(at_rest)), length(dFdy(at_rest)));
    vec3 moved = water_at(at_rest, drawn).moved;
    vec3 travel = travelled(at_rest, moved.xz, seen);
    vec2 then = at_rest - travel.xy;
    vec3 way = moved_before(then, drawn) - moved;
    way += vec3(then.x - at_rest.x, water_before.level_m - water_now.level_m, then.y - at_rest.y);
    put_motion(from_to.now * vec4(position, 1.0), from_to.before * vec4(position + way, 1.0), view.size);
    moved_since.a = clamp(1.0 - travel.z, 0.05, 1.0);
}
