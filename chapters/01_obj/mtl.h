// MTL reader: the material file that an OBJ file names with `mtllib`.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/material.h"

namespace lightwalk {

/// Every material of an MTL file. Knows Ka Kd Ks Ke Ns d Tr Ni illum Pr Pm, their maps, bump, norm and disp, and every
/// map option; keeps of the options what TextureMap holds. Ignores other statements, and spectral and xyz colours.
/// Map files are resolved against the file's folder, backslashes as slashes; whether they exist is not looked at.
/// Throws InputError with file, line and reason.
std::vector<Material> load_mtl(const std::filesystem::path& path);

/// As load_mtl, from memory; `name` stands for the file in messages.
std::vector<Material> parse_mtl(std::string_view text, const std::string& name, const std::filesystem::path& folder);

/// One material for each name after `usemtl`, from the files after `mtllib`. What is missing is a warning on stderr.
std::vector<Material> find_materials(const std::vector<std::string>& names, const std::vector<std::string>& libraries,
                                     const std::filesystem::path& folder);

}  // namespace lightwalk
