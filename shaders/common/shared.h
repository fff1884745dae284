// Lets one header be GLSL and C++: between BEGIN_SHARED and END_SHARED use GLSL's type names. A function there begins
// with SHARED_FUNCTION. For C++ alone, hence <...>: in GLSL all three are empty from the beginning (common/gpu/flatten.cpp).
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#define BEGIN_SHARED      \
    namespace lightwalk { \
    using namespace glm;
#define END_SHARED }
#define SHARED_FUNCTION inline
