// Loader on several threads, which take chunks of the text. All errors go to throw_first_error.
#include <thread>

#include "01_obj/lines.h"
#include "01_obj/scan.h"
#include "common/base/progress.h"

namespace lightwalk {
namespace {

// True where the line break at text[at] ends a line that a backslash joins to the next.
bool joins_lines(std::string_view text, size_t at) {
    while (at > 0 && is_space(text[at - 1])) --at;
    return at > 0 && text[at - 1] == '\\';
}

// Chunks of `bytes` and as much more as it takes not to end within a statement.
std::vector<std::string_view> chunks_of(std::string_view text, size_t bytes) {
    std::vector<std::string_view> chunks;
    while (!text.empty()) {
        size_t end = text.find('\n', bytes - 1);
        while (end != text.npos && joins_lines(text, end)) end = text.find('\n', end + 1);
        chunks.push_back(text.substr(0, end == text.npos ? end : end + 1));
        text.remove_prefix(chunks.back().size());
    }
    return chunks;
}

}  // namespace

// A single chunk's lists become the result, those of several are copied: below 8 MiB two threads save less than that
// takes. The smallest chunk of many threads takes as long as a thread needs to start.
size_t chunk_bytes_for(size_t text_bytes, unsigned threads) {
    constexpr size_t mebi = size_t{1} << 20;
    if (threads < 3 && text_bytes < 8 * mebi) return 8 * mebi;
    return std::clamp(text_bytes / (2 * threads), mebi / 4, mebi);
}

ObjData parse_parallel(std::string_view text, const std::string& name, ParseOptions options) {
    const unsigned threads = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
    const std::vector<std::string_view> chunks = chunks_of(text, std::max<size_t>(options.chunk_bytes, 1));
    std::vector<Collected> collected(std::min<size_t>(threads, chunks.size()));
    std::vector<Piece> pieces(chunks.size());
    for (Collected& c : collected) reserve(c, text.size());
    ObjData data;
    try {
        Progress* const waited_for = progress();
        if (waited_for) waited_for->begin("reading", text.size());
        on_threads(threads, chunks.size(), [&](unsigned thread, size_t i) {
            if (waited_for) waited_for->step(chunks[i].size());
            pieces[i] = read_lines(chunks[i], collected[thread]);
        });
    } catch (const Cancelled&) { throw; } catch (const InputError&) {
        throw_first_error(text, name);
    }
    bool absent = false;
    if (!assemble(pieces, threads, name, data, absent)) throw_first_error(text, name);
    if (absent) warn_of_absent(text, name);
    return data;
}

}  // namespace lightwalk
