#include "01_obj/loaders.h"
namespace lightwalk {
ObjData parse_parallel(std::string_view text, const std::string& name, ParseOptions) { return parse_scan(text, name); }
}  // namespace lightwalk
