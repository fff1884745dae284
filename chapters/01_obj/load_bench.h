// Benchmark of the loaders, and a summary of the mesh that one of them has read.
#pragma once
#include <filesystem>
#include <string>

#include "01_obj/model_chapter.h"
#include "01_obj/obj.h"
#include "common/study/subject.h"

namespace lightwalk {

/// Measures files instead of frames.
struct LoaderSubject : Subject {
    LoaderSubject(const SceneFile& file_of_scene, Choice& loader_knob) : scene(file_of_scene), loader(loader_knob) {}

    /// Every loader on study["scenes"] (files, from the root; one that is missing is left out with a warning),
    /// study["rounds"] times each.
    void measure(const nlohmann::json& study, nlohmann::json& result) override;

    /// The fastest loader for the scene's .obj files with an error of at most `budget` ULP.
    nlohmann::json choose(double budget) override;

    const SceneFile& scene;
    Choice& loader;
};

/// Times every loader on an OBJ file, `runs` times each in turn (A B C A B C ...) after one round that is not counted,
/// and prints a table. Timed is parse_obj: from the file's name, its bytes in the page cache, to arrays of
/// positions, uvs and normals and triangulated index triples; Assimp also joins equal vertices. Beside the median
/// stands the error against truth.h: the largest distance in ULP, the number of floats that are not the nearest, and
/// the share of triangles that are the same three corners in the same place. Returns the exit code. Throws InputError
/// where the reference cannot read the file.
int run_load_bench(const std::filesystem::path& path, int runs);

/// Prints a loader's result for a model file as JSON: counts, bounds, materials, and a checksum of the positions,
/// FNV-1a 64 over their floats' bits as little-endian bytes in file order (for formats other than OBJ: of the
/// vertices, mesh after mesh). Equal positions give equal checksums.
void dump_mesh(const std::filesystem::path& path, Loader loader);

}  // namespace lightwalk
