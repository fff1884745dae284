// Measures car paint by random walks: assets/tables/flakes.binary, and the full size of published files.
//
//     ninja -C build walk_paint && build/walk_paint assets/tables/flakes.binary
//     build/walk_paint full.binary 90        35 MB, some minutes
#include <cstdio>
#include <exception>
#include <string>

#include "14_environment/paint_fit.h"
#include "14_environment/paint_walk.h"
#include "common/base/files.h"

using namespace lightwalk;

int main(int count, char** words) try {
    const int cells = count == 3 ? std::stoi(words[2]) : 30;
    if (count < 2 || count > 3 || cells < 2 || cells > 128) {
        std::fputs("usage: walk_paint FILE.binary [CELLS along theta_h and theta_d, 2 to 128; 30]\n", stderr);
        return 2;
    }
    const MeasuredBrdf brdf = measure_by_walks({}, {cells, cells, 2 * cells}, 1024);
    write_file(words[1], measured_bytes(brdf));
    const PaintFit fit = fit_paint(brdf);
    const auto print = [](const char* name, glm::vec3 v) { std::printf("%s %.3f,%.3f,%.3f\n", name, v.r, v.g, v.b); };
    print("paint.color", fit.color);
    print("paint.edge_color", fit.edge_color);
    print("paint.flake_color", fit.flake_color);
    std::printf("paint.flakes %.3f\npaint.flake_roughness %.3f\n", fit.flakes, fit.flake_roughness);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
