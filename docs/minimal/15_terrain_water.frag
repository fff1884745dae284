// [minimal]
#version 460
// Water with waves: reflection, the view below the surface, and their mixture. One run for each pixel.
layout(location = 0) in vec3 ray;     // of the pixel
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { vec4 eye; vec4 to_sun; float time; };  // metres, +y up; seconds

struct Wave { vec2 k; float amplitude, steepness; };  // k: 2 pi / wavelength, along its direction
const Wave waves[4] = Wave[](Wave(vec2(0.5, 0.2), 0.3, 0.5), Wave(vec2(-0.4, 0.9), 0.16, 0.5),
                             Wave(vec2(1.5, 1.1), 0.08, 0.6), Wave(vec2(2.9, -1.3), 0.04, 0.6));

// Where the water that rests at (x, 0, z) is now, by F. Gerstner (1802): in circles. The columns of `slopes` are the
// derivatives of that place by x and by z, summed over all waves.
vec3 moved(vec2 at, float time, out mat2x3 slopes) {
    vec3 place = vec3(at.x, 0.0, at.y);
    slopes = mat2x3(vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0));
    for (int i = 0; i < 4; ++i) {
        vec2 k = waves[i].k, along = waves[i].steepness * normalize(k);
        float phase = dot(k, at) - sqrt(9.81 * length(k)) * time;  // long waves are faster
        place += waves[i].amplitude * vec3(along.x * cos(phase), sin(phase), along.y * cos(phase));
        vec3 change = waves[i].amplitude * vec3(-along.x * sin(phase), cos(phase), -along.y * sin(phase));
        slopes += mat2x3(k.x * change, k.y * change);
    }
    return place;
}

// The water at rest that a ray from above meets, found again and again from where it has moved to.
vec2 met(vec3 from, vec3 direction, float time) {
    mat2x3 slopes;
    vec2 at = vec2(0.0);
    float height = 0.0;
    for (int i = 0; i < 24; ++i) {
        vec3 level = from + (height - from.y) / direction.y * direction;
        at = i == 0 ? level.xz : at + 0.7 * (level - moved(at, time, slopes)).xz;
        height = moved(at, time, slopes).y;
    }
    return at;
}
// C. Schlick (1994), with the 2% that water reflects of light from straight above.
float fresnel(float cosine) { return 0.02 + 0.98 * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0); }

// Of light that comes up through `way` metres of water: red is lost first.
vec3 left_of_light(float way) { return exp(-vec3(0.45, 0.11, 0.07) * way); }

vec3 sky(vec3 d) {
    vec3 blue = mix(vec3(0.75, 0.82, 0.9), vec3(0.15, 0.35, 0.75), sqrt(max(d.y, 0.0)));
    return blue + 40.0 * pow(max(dot(d, to_sun.xyz), 0.0), 4000.0);
}

void main() {
    vec3 direction = normalize(ray);
    color = vec4(sky(direction), 1.0);
    if (direction.y > -0.01) return;
    mat2x3 slopes;
    vec3 place = moved(met(eye.xyz, direction, time), time, slopes), normal = normalize(cross(slopes[1], slopes[0]));
    vec3 below = refract(direction, normal, 1.0 / 1.333), mirrored = reflect(direction, normal);
    vec3 bed = 0.3 * left_of_light(3.0 / max(-below.y, 0.1) + 3.0);  // sand, 3 m deep
    color.rgb = mix(bed, sky(vec3(mirrored.x, abs(mirrored.y), mirrored.z)), fresnel(dot(normal, -direction)));
}
// [/minimal]
