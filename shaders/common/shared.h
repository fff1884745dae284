// Headers read by GLSL and C++: GLSL's type names between BEGIN_SHARED and END_SHARED, functions marked
// SHARED_FUNCTION. Included with <...>, so for C++ alone: common/gpu/flatten.cpp predefines all three as empty for
// GLSL.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#define BEGIN_SHARED      \
    namespace lightwalk { \
    using namespace glm;
#define END_SHARED }
#define SHARED_FUNCTION inline
