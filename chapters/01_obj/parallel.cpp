// Loader on several threads: the file is mapped, threads take chunks of it, and the common forms of v, vt, vn and f are
// read eight characters at a time. All other lines go to the scanner, all errors to throw_first_error.
#include <sys/mman.h>

#include <thread>

#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "01_obj/loaders.h"
#include "01_obj/scan.h"
#include "01_obj/threads.h"
#include "common/base/progress.h"

namespace lightwalk {
namespace {

const char* end_of_line(const char* at) {
    if (*at == '\r') ++at;
    return *at == '\n' ? at + 1 : nullptr;
}

// `count` numbers with one space before each. Returns the next line, or null for any other form.
template <int count>
const char* read_numbers(const char* at, float* values) {
    for (int i = 0; i < count; ++i) {
        if (*at != ' ') return nullptr;
        if (!(at = fast_float(at + 1, values[i]))) return nullptr;
    }
    return end_of_line(at);
}

template <int count>
const char* numbers_line(const char* at, Array<float>& into) {
    at = read_numbers<count>(at, into.room(count));
    if (at) into.added(count);
    return at;
}

// A face with all corners in the first one's form, with positive indices.
template <bool has_uv, bool has_normal>
const char* read_corners(const char* at, Collected& into) {
    size_t count = 0;
    Corner* corner = into.corners.room(8);
    for (; *at == ' '; ++count) {
        if (count % 8 == 7) corner = into.corners.room(count + 9);
        Corner c;
        if (!(at = fast_index(at + 1, c.position))) return nullptr;
        if (has_uv || has_normal)
            if (*at++ != '/') return nullptr;
        if (has_uv && !(at = fast_index(at, c.uv))) return nullptr;
        if (has_normal && (*at != '/' || !(at = fast_index(at + 1, c.normal)))) return nullptr;
        corner[count] = {c.position - 1, has_uv ? c.uv - 1 : none, has_normal ? c.normal - 1 : none};
    }
    if (count < 3 || count > most_corners || !(at = end_of_line(at))) return nullptr;
    into.corners.added(count);
    into.sizes.push_back(static_cast<uint32_t>(count));
    return at;
}

const char* face_line(const char* at, Collected& into) {
    // The first corner says which of the four forms it is.
    const char* p = at + 1;
    while (*p >= '0' && *p <= '9') ++p;
    if (*p != '/') return read_corners<false, false>(at, into);
    if (*++p == '/') return read_corners<false, true>(at, into);
    while (*p >= '0' && *p <= '9') ++p;
    return *p == '/' ? read_corners<true, true>(at, into) : read_corners<true, false>(at, into);
}

// Lines of uncommon form are the scanner's. Throws InputError without a line.
Piece read_chunk(std::string_view text, Collected& into) {
    Scanner scanner(into);
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        const char* next = nullptr;
        if (at[0] == 'v') {
            if (at[1] == ' ')
                next = numbers_line<3>(at + 1, into.positions);
            else if (at[1] == 't' && at[2] == ' ')
                next = numbers_line<2>(at + 2, into.uvs);
            else if (at[1] == 'n' && at[2] == ' ')
                next = numbers_line<3>(at + 2, into.normals);
        } else if (at[0] == 'f' && at[1] == ' ') {
            next = face_line(at + 1, into);
        }
        if (!next) {
            Statements statements(std::string_view(at, static_cast<size_t>(end - at)));
            if (std::string_view statement; statements.next(statement)) scanner.statement(statement);
            next = statements.rest().data();
        }
        at = next;
    }
    return scanner.piece();
}

// True where the line break at text[at] ends a line that a backslash joins to the next.
bool joins_lines(std::string_view text, size_t at) {
    while (at > 0 && is_space(text[at - 1])) --at;
    return at > 0 && text[at - 1] == '\\';
}

// [chunks]
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
// [/chunks]

// Maps the chunk's pages at once instead of one fault for every few of them. Not every kernel can; nothing is lost
// then.
void populate(std::string_view text) {
    const uintptr_t page = 4096, begin = reinterpret_cast<uintptr_t>(text.data()) & ~(page - 1);
    madvise(reinterpret_cast<void*>(begin), reinterpret_cast<uintptr_t>(text.end()) - begin, MADV_POPULATE_READ);
}

}  // namespace

ObjData parse_parallel(std::string_view text, const std::string& name, ParseOptions options) {
    const unsigned threads = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
    // Two for each thread, but none of less than a thread costs.
    const size_t even = std::max(text.size() / (2 * threads), size_t{1} << 17);
    const std::vector<std::string_view> chunks =
        chunks_of(text, std::max<size_t>(std::min(options.chunk_bytes, even), 1));
    std::vector<Collected> collected(std::min<size_t>(threads, chunks.size()));
    std::vector<Piece> pieces(chunks.size());
    for (Collected& c : collected) {
        // An estimate. Memory that is not touched costs nothing.
        c.corners.reserve(text.size() / 16);
        for (Array<float>* values : {&c.positions, &c.uvs, &c.normals}) values->reserve(text.size() / 16);
        c.sizes.reserve(text.size() / 32);
    }
    ObjData data;
    try {
        Progress* const waited_for = progress();
        if (waited_for) waited_for->begin("reading", text.size());
        // [threads]
        on_threads(threads, chunks.size(), [&](unsigned thread, size_t i) {
            if (waited_for) waited_for->step(chunks[i].size());
            populate(chunks[i]);
            pieces[i] = read_chunk(chunks[i], collected[thread]);
        });
        // [/threads]
    } catch (const Cancelled&) { throw; } catch (const InputError&) {
        throw_first_error(text, name);
    }
    bool absent = false;
    if (!assemble(pieces, threads, name, data, absent)) throw_first_error(text, name);
    if (absent) warn_of_absent(text, name);
    return data;
}

}  // namespace lightwalk
