// The volume before the eye: inscattered light up to a distance, and transmittance. Its slices lie closer near the
// eye. A thread is a ray; it stores its running sums at each slice.
#include "common/structs.h"
#include "10_atmosphere/sun_table.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/view_path.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image3D result;        // light
layout(rgba16f) writeonly uniform image3D transmitted;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform SunBlock { vec3 to_sun; };
layout(scalar) uniform ReachBlock { vec3 reach; };  // the picture's size in pixels; how far the last slice is

void main() {
    ivec3 size = imageSize(result);
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, size.xy))) return;
    vec3 ray = ray_through(rays, vec2(texel) / vec2(size.xy - 1) * reach.xy);
    Path path = path_from(rays.eye, normalize(ray), to_sun);
    path.height = max(path.height, 0.0);
    Along all = Along(vec3(0.0), vec3(1.0));
    float from = 0.0;
    for (int slice = 0; slice < size.z; ++slice) {
        float share = float(slice) / float(size.z - 1), to = share * share * reach.z;
        Path part = path_on(path, from);
        part.way = to - from;
        Along more = in_scatter(2, part);
        all = Along(all.light + all.transmittance * more.light, all.transmittance * more.transmittance);
        from = to;
        imageStore(result, ivec3(texel, slice), vec4(min(all.light, LARGEST_HALF), 1.0));
        imageStore(transmitted, ivec3(texel, slice), vec4(all.transmittance, 1.0));
    }
}
