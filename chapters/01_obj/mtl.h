// MTL reader: the material file that an OBJ file names with `mtllib`.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/material.h"

namespace lightwalk {

/// For a material with Tr and without d. Most programs write the transparency, 1 - d; some, MeshLab and OpenMVS among
/// them, write Tr 1 for opaque. `safe`: transparency, except that a material that would vanish is opaque.
enum class Tr { safe, transparency, opacity };

/// Every material of an MTL file. Supports Ka Kd Ks Ke Ns d Tr Tf Ni illum Pr Pm, their maps, bump, norm and disp, and
/// every map option. Other visible properties are listed in `left_out`, spectral and xyz colours included. Map files
/// are resolved against the file's folder, with backslashes as slashes; their existence is not checked. Throws
/// InputError with file, line and reason.
std::vector<Material> load_mtl(const std::filesystem::path& path, Tr tr = Tr::safe);

/// As load_mtl, from memory; `name` stands for the file in messages.
std::vector<Material> parse_mtl(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                                Tr tr = Tr::safe);

/// One material for each name after `usemtl`, from the files after `mtllib`. Warns on stderr about missing ones.
std::vector<Material> find_materials(const std::vector<std::string>& names, const std::vector<std::string>& libraries,
                                     const std::filesystem::path& folder, Tr tr = Tr::safe);

}  // namespace lightwalk
