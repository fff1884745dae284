// G-buffer outputs of fragment shaders.
#include "06_deferred/gbuffer.glsl"

#if GBUFFER_IS_PACKED
layout(location = 0) out uint normals;
layout(location = 1) out uint diffuse;
layout(location = 2) out uint specular;
#else
layout(location = 0) out vec4 normal;
layout(location = 1) out vec4 diffuse;
layout(location = 2) out vec4 specular;
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
layout(location = 3) out vec4 position;
#endif
#endif

void put_pixel(Pixel p) {
    Stored s = store(p);
    diffuse = s.diffuse;
    specular = s.specular;
#if GBUFFER_IS_PACKED
    normals = s.normals;
#else
    normal = s.normal;
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
    position = s.position;
#endif
#endif
}
