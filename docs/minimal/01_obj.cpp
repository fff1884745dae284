// [minimal]
// An OBJ reader: text on standard input, vertices and triangles as a graphics processor takes them.
#include <array>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using Vec = std::array<double, 3>;

struct Vertex {
    Vec position, texture, normal;
};

int main() {
    std::vector<Vec> lists[3];                       // `v`, `vt` and `vn` read so far
    std::map<std::array<size_t, 3>, unsigned> seen;  // the vertex of each index triple
    std::vector<Vertex> vertices;
    std::vector<unsigned> indices;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v" || word == "vt" || word == "vn") {
            Vec value{};
            for (double& number : value) words >> number;
            lists[word == "v" ? 0 : word == "vt" ? 1 : 2].push_back(value);
        }
        if (word != "f") continue;
        std::vector<unsigned> polygon;
        while (words >> word) {              // "7", "7/1", "7//3" or "7/1/3"; -1 is the last one so far
            std::array<size_t, 3> triple{};  // 0: none
            char* at = word.data();
            for (size_t i = 0; i < 3; ++i, ++at) {
                const long index = strtol(at, &at, 10), count = static_cast<long>(lists[i].size());
                triple[i] = static_cast<size_t>(index < 0 ? index + count + 1 : index);
                if (triple[i] > lists[i].size()) return std::puts("an index that names nothing"), 1;
                if (*at != '/') break;
            }
            // One vertex for all corners with the same position, texture coordinate and normal.
            const auto [entry, is_new] = seen.try_emplace(triple, static_cast<unsigned>(vertices.size()));
            const auto value = [&](size_t i) { return triple[i] ? lists[i][triple[i] - 1] : Vec{}; };
            if (is_new) vertices.push_back({value(0), value(1), value(2)});
            polygon.push_back(entry->second);
        }
        for (size_t i = 2; i < polygon.size(); ++i)  // a fan, right for convex polygons
            for (size_t corner : {size_t{0}, i - 1, i}) indices.push_back(polygon[corner]);
    }
    double volume = 0;  // of a closed mesh: the signed tetrahedra between its triangles and the origin
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        Vec p[3];
        for (size_t k = 0; k < 3; ++k) p[k] = vertices[indices[i + k]].position;
        for (size_t k = 0, l = 1, m = 2; k < 3; ++k, l = (l + 1) % 3, m = (m + 1) % 3)
            volume += p[0][k] * (p[1][l] * p[2][m] - p[1][m] * p[2][l]) / 6;
    }
    std::printf("vertices %zu\ntriangles %zu\nvolume %.6f\n", vertices.size(), indices.size() / 3, volume);
}
// [/minimal]
