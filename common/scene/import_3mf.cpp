#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>

#include "common/scene/import_parts.h"

namespace lightwalk {
namespace {

template <class T>
T number_at(std::string_view bytes, size_t at) {
    T value{};
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, &bytes[at], sizeof value);
    return value;
}

// ZIP entry (PKWARE APPNOTE.TXT, 4.3.7 and 4.3.12); empty if unreadable.
std::string member(std::string_view zip, size_t entry) {
    constexpr size_t most_bytes = size_t{1} << 28;
    const size_t packed = number_at<uint32_t>(zip, entry + 20), size = number_at<uint32_t>(zip, entry + 24);
    const size_t local = number_at<uint32_t>(zip, entry + 42);
    const size_t from = local + 30 + number_at<uint16_t>(zip, local + 26) + number_at<uint16_t>(zip, local + 28);
    if (from > zip.size() || packed > zip.size() - from || size > most_bytes) return {};
    if (number_at<uint16_t>(zip, entry + 10) == 0) return std::string(zip.substr(from, packed));
    std::string text(size, '\0');
    z_stream stream{};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(zip.data() + from));
    stream.avail_in = static_cast<uInt>(packed);
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(size);
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};  // raw deflate
    inflate(&stream, Z_FINISH);
    text.resize(stream.total_out);
    inflateEnd(&stream);
    return text;
}

std::string_view attribute(std::string_view xml, std::string_view tag, std::string_view name) {
    const size_t begin = xml.find(tag);
    if (begin == xml.npos) return {};
    const std::string_view inside = xml.substr(begin, xml.find('>', begin) - begin);
    const size_t at = inside.find(std::string(" ") + std::string(name) + "=\"");
    if (at == inside.npos) return {};
    const size_t first = at + name.size() + 3;
    return inside.substr(first, inside.find('"', first) - first);
}

}  // namespace

float metres_of_3mf(std::string_view bytes, Model& model) {
    static const std::map<std::string_view, float> units = {{"micron", 1e-6f},     {"millimeter", 1e-3f},
                                                            {"centimeter", 1e-2f}, {"inch", 0.0254f},
                                                            {"foot", 0.3048f},     {"meter", 1}};
    float metres = 1e-3f;
    constexpr std::string_view mark("PK\1\2", 4);  // signature of a central directory entry
    for (size_t entry = bytes.find(mark); entry != bytes.npos; entry = bytes.find(mark, entry + 4)) {
        const std::string_view name =
            entry + 46 < bytes.size() ? bytes.substr(entry + 46, number_at<uint16_t>(bytes, entry + 28)) : "";
        if (!name.ends_with(".model")) continue;
        const std::string xml = member(bytes, entry);
        if (const auto unit = units.find(attribute(xml, "<model", "unit")); unit != units.end()) metres = unit->second;
        if (xml.find(" p1=\"") != xml.npos) leave_out(model, "colours of triangles");
        for (const char* group : {"colorgroup", "texture2dgroup", "compositematerials", "multiproperties"})
            if (xml.find(std::string(":") + group + " ") != xml.npos) leave_out(model, group);
    }
    return metres;
}

}  // namespace lightwalk
