// Two unit vectors in one word.
#include "06_deferred/encode_normal.glsl"
#include "06_deferred/decode_normal.glsl"
#include "06_deferred/quantise.glsl"
