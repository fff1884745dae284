#include "agreement.h"

#include "common/base/error.h"

namespace lightwalk {
namespace {

std::string difference(const Outcome& a, const Outcome& b) {
    if (a.place != b.place) return "error '" + a.error + "' against '" + b.error + "'";
    if (!(a.data.positions == b.data.positions)) return "positions differ";
    if (!(a.data.uvs == b.data.uvs)) return "uvs differ";
    if (!(a.data.normals == b.data.normals)) return "normals differ";
    if (!(a.data.colors == b.data.colors)) return "colours differ";
    if (a.data.left_out != b.data.left_out) return "what is left out differs";
    if (!(a.data.corners == b.data.corners)) return "indices differ";
    if (a.data.runs != b.data.runs) return "runs differ";
    if (a.data.objects != b.data.objects || a.data.groups != b.data.groups || a.data.materials != b.data.materials ||
        a.data.libraries != b.data.libraries)
        return "names differ";
    return {};
}

}  // namespace

Outcome outcome_of(std::string_view text, Loader loader, ParseOptions options) {
    Outcome outcome;
    try {
        outcome.data = parse_obj_text(std::string(text), "test.obj", loader, options);
    } catch (const InputError& error) {
        outcome.error = error.what();
        outcome.place = outcome.error.substr(0, outcome.error.find(": "));
    }
    return outcome;
}

std::string disagreement(std::string_view text) {
    const Outcome expected = outcome_of(text, Loader::textbook);
    const Outcome scanned = outcome_of(text, Loader::scan);
    if (const std::string found = difference(expected, scanned); !found.empty()) return "textbook and scan: " + found;
    for (const ParseOptions options : {ParseOptions(), {1, 3}, {7, 2}, {64, 1}, {1000, 2}})
        if (const std::string found = difference(scanned, outcome_of(text, Loader::parallel, options)); !found.empty())
            return "scan and parallel with chunks of " + std::to_string(options.chunk_bytes) + " bytes on " +
                   std::to_string(options.threads) + " threads: " + found;
    return {};
}

}  // namespace lightwalk
