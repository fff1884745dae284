// Which blocks hold something that the transfer function shows: 1, or 0.
#include "16_volume/volume_data.h"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
uniform sampler3D ranges;
uniform sampler2D volume_transfer;
layout(r8) writeonly uniform image3D result;

void main() {
    ivec3 block = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(block, imageSize(result)))) return;
    float most = 0.0;
    bool outside = any(greaterThanEqual(block, textureSize(ranges, 0)));  // levels have whole blocks, the volume need not
    vec2 range = outside ? vec2(0.0, -1.0) : min(texelFetch(ranges, block, 0).rg, 1.0) * float(TRANSFER_TEXELS - 1);
    for (int i = int(floor(range.x)); i <= min(int(ceil(range.y)), TRANSFER_TEXELS - 1); ++i)
        most = max(most, texelFetch(volume_transfer, ivec2(i, 0), 0).a);
    imageStore(result, block, vec4(most > 0.0 ? 1.0 : 0.0));
}
