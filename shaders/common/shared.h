// Lets one header be GLSL and C++: between BEGIN_SHARED and END_SHARED use GLSL's type names. A function there begins
// with SHARED_FUNCTION.
#pragma once
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define BEGIN_SHARED      \
    namespace lightwalk { \
    using namespace glm;
#define END_SHARED }
#define SHARED_FUNCTION inline
#else
#define BEGIN_SHARED
#define END_SHARED
#define SHARED_FUNCTION
#endif
