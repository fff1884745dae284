#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(location = 0) flat in int number;  // of the draw
layout(location = 0) out vec4 color;

// [textures]
#if defined(ONE)
layout(binding = 0) uniform sampler2D picture;
#elif defined(LAYERS_BY_OFFSET) || defined(LAYERS_BY_BUFFER)
layout(binding = 0) uniform sampler2DArray pictures;  // layers of one image: equal sizes, one format
#else
layout(binding = 0) uniform sampler2D pictures[2048];  // a table of images of any size
#endif
// [/textures]

// [index]
#if defined(LAYERS_BY_OFFSET)
layout(binding = 1) uniform Choice { int chosen; };  // a block of the draw, at a dynamic offset
#elif defined(TABLE_BY_CONSTANT)
layout(push_constant) uniform Choice { int chosen; };
#elif !defined(ONE)
layout(std430, binding = 1) readonly buffer Choices { int choices[]; };
#define chosen choices[number]
#endif
// [/index]

// [read]
void main() {
    vec2 at = vec2(0.5);
#if defined(ONE)
    color = texture(picture, at);
#elif defined(LAYERS_BY_OFFSET) || defined(LAYERS_BY_BUFFER)
    color = texture(pictures, vec3(at, chosen));
#else
    color = texture(pictures[nonuniformEXT(chosen)], at);
#endif
}
// [/read]
