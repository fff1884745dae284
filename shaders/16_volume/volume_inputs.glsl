// A volume as its passes read it: densities from 0 to 1, and the colour and opacity that the transfer function gives them.
#include "16_volume/volume_data.h"

layout(scalar) uniform VolumeNowBlock { VolumeNow volume_now; };
uniform sampler3D volume_field;
uniform sampler2D volume_transfer;

// A density that is no number counts as 0: else one bad voxel darkens all rays that pass it, and filters spread it.
float density_of(float stored) { return stored > 0.0 ? min(stored, 1.0) : 0.0; }

// From metres in the world to 0 to 1 in the volume.
vec3 to_texture(vec3 position) { return 0.5 + 0.5 * (volume_now.to_volume * position / volume_now.half_m); }

float stored_density(vec3 at) { return density_of(textureLod(volume_field, at, 0.0).r); }

// Three sums of sines displace the place that is sampled, 0 to 1 in the volume. The CPU keeps time in double precision and
// passes each phase as an angle from 0 to 2 pi.
vec3 waved(vec3 at) {
    if (volume_now.wave == 0.0) return at;
    vec3 turn = 6.2831853 * at;
    return at + volume_now.wave * vec3(sin(2.0 * turn.y + volume_now.wave_phase.x) + 0.5 * sin(5.0 * turn.z - volume_now.wave_phase.y),
                                       sin(2.0 * turn.z + volume_now.wave_phase.y) + 0.5 * sin(5.0 * turn.x - volume_now.wave_phase.z),
                                       sin(2.0 * turn.x + volume_now.wave_phase.z) + 0.5 * sin(5.0 * turn.y - volume_now.wave_phase.x));
}

float density_at(vec3 position) { return stored_density(waved(to_texture(position))); }

// Colour, and the opacity of REFERENCE_M metres of it.
vec4 classified(float density) {
    const float texels = float(TRANSFER_TEXELS);
    return textureLod(volume_transfer, vec2((density * (texels - 1.0) + 0.5) / texels, 0.5), 0.0);
}
