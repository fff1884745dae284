// The five loaders, each in its own file: text in, triangles out. parse_obj calls one of them.
#pragma once
#include <string>
#include <string_view>

#include "01_obj/obj.h"

namespace lightwalk {

// All throw InputError with file, line and reason; `name` is the file in messages.
ObjData parse_textbook(std::string_view text, const std::string& name);
ObjData parse_scan(std::string_view text, const std::string& name);
/// `text` must be followed by at least 64 readable zero bytes.
ObjData parse_parallel(std::string_view text, const std::string& name, ParseOptions options);
/// How parse_parallel() cuts a text: two chunks for each thread, but a single one where threads take no less time.
size_t chunk_bytes_for(size_t text_bytes, unsigned threads);
/// parse_tinyobjloader() or parse_assimp() in a guarded process, with its result checked.
ObjData parse_guarded(std::string_view text, const std::string& name, Loader loader);
/// Without objects and groups, which it does not tell apart; splits a quadrilateral along its shorter diagonal.
ObjData parse_tinyobjloader(std::string_view text, const std::string& name);
/// Positions, uvs and normals are Assimp's joined vertices, so the three indices of a corner are equal.
ObjData parse_assimp(std::string_view text, const std::string& name);

}  // namespace lightwalk
