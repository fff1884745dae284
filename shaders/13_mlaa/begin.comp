// Nothing is listed yet.
#include "13_mlaa/work.glsl"
layout(local_size_x = 1) in;
void main() {
    work.groups[0] = 0u;
    work.groups[1] = 1u;
    work.groups[2] = 1u;
    work.listed_count = 0u;
    work.changed_count = 0u;
}
