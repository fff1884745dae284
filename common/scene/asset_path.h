// File names written into model and material files by other programs.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lightwalk {

/// File named in a model file, tolerating quotes, backslashes, other capitalisation and absolute Windows paths.
std::filesystem::path resolve_file(std::string_view written, const std::filesystem::path& folder);

/// Files named in one statement, such as an OBJ file's mtllib: the whole text where such a file exists; else the longest
/// runs of words that name files, in order, and a word for each that does not. Names may be quoted.
std::vector<std::filesystem::path> resolve_files(std::string_view written, const std::filesystem::path& folder);

/// Decodes percent-encoded URIs (RFC 3986, 2.1), as used by glTF and Collada.
std::string decode_uri(std::string_view text);

/// File named by a URI in a model file: percent-encoded, or as some programs write it, and else as resolve_file().
std::filesystem::path resolve_uri(std::string_view uri, const std::filesystem::path& folder);

/// Bytes of a model file and, for glTF, of the files it references. Throws InputError if the model file is missing.
size_t bytes_to_import(const std::filesystem::path& path);

}  // namespace lightwalk
