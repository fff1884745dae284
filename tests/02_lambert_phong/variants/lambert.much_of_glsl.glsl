// right
#define HALF(x) ((x) / 2.0)
const float two = 4.0 / 2.0, tiny = pow(10.0, -6.0);
const int count = 3;

struct Pair {
    vec3 a, b;
};

float square(in float x) { return x * x; }

void add(inout float sum, const float x) { sum += x / 1.0; }

float along(Pair pair) {
    float products[3] = float[](pair.a.x * pair.b.x, pair.a.y * pair.b.y, pair.a.z * pair.b.z), sum = 0.0;
    for (int i = 0; i < count; ++i) add(sum, products[i % 3] * float(2 * i + 2) / float((i + 1) * 2));
    uint n = 7u / 2u;
    ivec2 cells = ivec2(9, 4) / ivec2(3, 2);
    n /= 3u;
    mat3 frame = mat3(1.0) / two;
    vec3 scaled = frame * vec3(sum) / vec3(1.0, 2.0, 4.0) * two;
    scaled.x /= float(cells.x) / 3.0;
    scaled.yz *= 1.0;
    float angle = atan(0.0, 1.0) + atan(0.0) + mod(float(cells.y), two) + smoothstep(0.0, 1.0, 0.0);
    return n == 1u ? clamp(scaled.x, -1.0, 1.0) + angle : max(min(1, 2), 3) / 0.5;
}

float lambert(vec3 normal, vec3 to_light) {
    Pair pair = Pair(normal, to_light);
    float cosine = HALF(2.0 * along(pair));
    switch (cosine > 0.0 ? 1 : 0) {
        case 1: return sqrt(square(cosine));
        default: break;
    }
    return 0.0;
}
