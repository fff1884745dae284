// The files that a model file names.
#pragma once
#include <filesystem>
#include <string>

namespace lightwalk {

/// glTF and Collada name files by URIs, in which a space is %20 (RFC 3986, 2.1).
std::string decode_uri(std::string_view text);

/// Size of a model file, plus, for glTF, of the files named by the key "uri", each once. Throws InputError if the
/// file itself does not exist.
size_t bytes_to_import(const std::filesystem::path& path);

}  // namespace lightwalk
