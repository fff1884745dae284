// For the check of 18.id_buffer: an image with known numbers; one outside has no value.
#pragma replaces "18_playground/ids.glsl"

ivec2 ids_size() { return ivec2(IDS_WIDTH, IDS_HEIGHT); }
uint id_at(ivec2 at) {
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, ids_size()));
    if (!inside) return 70000000u;
    return (7 * at.x + 13 * at.y) % IDS_EVERY == 3 ? uint(16777216 + at.y * IDS_WIDTH + at.x) : 0u;
}
