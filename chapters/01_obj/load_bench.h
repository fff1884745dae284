// Measuring the loaders, and showing what one has read.
#pragma once
#include <filesystem>
#include <string>

#include "01_obj/obj.h"

namespace lightwalk {

/// Times every loader on an OBJ file, `runs` times each in turn (A B C A B C ...) after one round that is not counted,
/// and prints a table, or JSON. Timed is parse_obj: from the file's name, its bytes in the page cache, to arrays of
/// positions, uvs and normals and triangulated index triples; Assimp also joins equal vertices. Beside the median
/// stands the error against truth.h: the largest distance in ULP, the number of floats that are not the nearest, and
/// the share of triangles that are the same three corners in the same place. Returns the exit code. Throws InputError
/// where the reference cannot read the file.
int run_load_bench(const std::filesystem::path& path, int runs, bool json);

/// Prints what a loader makes of a model file, as JSON: counts, bounds, materials, and a checksum of the positions,
/// FNV-1a 64 over their floats' bits as little-endian bytes in the order of the file (for a format other than OBJ: of
/// the vertices, mesh after mesh). Two loaders that read the same positions print the same checksum.
void dump_mesh(const std::filesystem::path& path, Loader loader);

/// What dump_mesh prints.
std::string describe_mesh(const std::filesystem::path& path, Loader loader);

}  // namespace lightwalk
