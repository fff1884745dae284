// [minimal]
// A camera path: a centripetal Catmull-Rom curve through keys (E. Lee, CAD 1989), followed at an even speed, with an up
// that does not roll. Prints the error of each of these.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>
struct Vec {
    double x, y, z;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
double distance(Vec a, Vec b) { return length(b + -1 * a); }

const std::vector<Vec> keys{{0, 0, 0}, {1, 0, 0}, {1.1, 0.1, 0}, {3, 2, 0}, {3, 4, 1}};
// Beyond the ends a key mirrored in the end stands in for the missing neighbour.
Vec key(int i) {
    const int last = int(keys.size()) - 1;
    return i < 0 ? 2 * keys[0] + -1 * keys[1] : i > last ? 2 * keys[last] + -1 * keys[last - 1] : keys[i];
}
// 1. The place at a parameter from 0 to 1: knots as far apart as the roots of distances, then three rounds of mixing.
Vec place(double u) {
    const double along = std::clamp(u, 0.0, 1.0) * double(keys.size() - 1);
    const int i = std::min(int(along), int(keys.size()) - 2);
    Vec p[4] = {key(i - 1), key(i), key(i + 1), key(i + 2)};
    double k[4] = {0};
    for (int j = 1; j < 4; ++j) k[j] = k[j - 1] + std::sqrt(distance(p[j - 1], p[j]));
    const double t = k[1] + (along - i) * (k[2] - k[1]);
    for (int round = 1; round < 4; ++round)
        for (int j = 0; j + round < 4; ++j) {
            const double from = k[round < 3 ? j : 1], to = k[round < 3 ? j + round : 2];
            p[j] = (1 / (to - from)) * ((to - t) * p[j] + (t - from) * p[j + 1]);
        }
    return p[0];
}
// 2. An up that turns with the view by the shortest way, between unit vectors. It is at a right angle to `from`.
Vec carried(Vec up, Vec from, Vec to) { return up + (-dot(up, to) / (1 + dot(from, to))) * (from + to); }
int main() {
    // 3. A table of lengths, and in it the parameter at which a share is covered.
    constexpr int pieces = 1024;
    std::vector<double> covered{0};
    const auto piece = [&](int i) { return distance(place((i - 1.0) / pieces), place(double(i) / pieces)); };
    for (int i = 1; i <= pieces; ++i) covered.push_back(covered.back() + piece(i));
    double slowest = 1e9, fastest = 0;
    for (int i = 0; i < 100; ++i) {
        const auto even = [&](double share) {
            const auto after = std::lower_bound(covered.begin() + 1, covered.end() - 1, share * covered.back());
            const double before = *(after - 1), within = (share * covered.back() - before) / (*after - before);
            return place((double(after - covered.begin()) - 1 + within) / pieces);
        };
        const double step = distance(even(i / 100.0), even((i + 1) / 100.0));
        slowest = std::min(slowest, step), fastest = std::max(fastest, step);
    }
    const Vec up = carried({0, 1, 0}, {0, 0, -1}, {0, std::sin(2.5), -std::cos(2.5)});  // over the zenith
    std::printf("key %.9f speed %.4f ", distance(place(0.25), keys[1]), fastest / slowest);
    std::printf("up %.9f\n", length(up));
}
// [/minimal]
