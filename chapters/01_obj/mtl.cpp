#include "01_obj/mtl.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/base/text.h"
#include "common/scene/asset_path.h"
#include "common/scene/model_bytes.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

float take_float(std::string_view& rest, std::string_view what) {
    const std::string_view word = next_word(rest);
    float value = 0.0f;
    if (word.empty()) throw InputError("a number is missing after {}", what);
    if (parse_float(word, value) != FloatStatus::ok)
        throw InputError("{} after {} is not a number that a float can hold", shown(word), what);
    return value;
}

// One number, or three; one stands for all three.
std::optional<glm::vec3> take_color(std::string_view rest, std::string_view what) {
    std::string_view peek = rest;
    if (const std::string_view form = next_word(peek); form == "spectral" || form == "xyz") return {};
    glm::vec3 color(take_float(rest, what));
    if (!next_value(peek).empty()) {
        color.y = take_float(rest, what);
        color.z = take_float(rest, what);
    }
    return color;
}

bool take_switch(std::string_view& rest, std::string_view what) {
    const std::string_view word = next_word(rest);
    if (word != "on" && word != "off") throw InputError("{} after {}, expected on or off", shown(word), what);
    return word == "on";
}

// Up to three numbers; the last word of a line is the file even where it is a number.
void take_up_to_three(std::string_view& rest, std::string_view what, glm::vec3& value) {
    value.x = take_float(rest, what);
    for (int i = 1; i < 3; ++i) {
        std::string_view after = rest;
        float number;
        if (parse_float(next_word(after), number) != FloatStatus::ok || trim(after).empty()) return;
        value[i] = number;
        rest = after;
    }
}

// -s and -o: the texture is repeated s times, and moved by o.
void place(TextureMap& map) {
    map.place.turn = glm::mat2(map.scale.x, 0, 0, map.scale.y);
    map.place.offset = glm::vec2(map.offset);
    if (map.clamp) map.sampler.wrap = Wrap::clamp;
}

// `left_out`: options that are read and not drawn.
TextureMap take_map(std::string_view rest, const fs::path& folder, std::vector<std::string>& left_out) {
    TextureMap map;
    for (rest = trim(rest); rest.starts_with('-');) {
        std::string_view after = rest;
        const std::string_view option = next_word(after);
        glm::vec3 dropped;
        if (option == "-bm")
            map.bump_multiplier = take_float(after, option);
        else if (option == "-o")
            take_up_to_three(after, option, map.offset);
        else if (option == "-s")
            take_up_to_three(after, option, map.scale);
        else if (option == "-t") {
            take_up_to_three(after, option, dropped);
            left_out.push_back("-t");
        } else if (option == "-mm") {
            map.base_gain.x = take_float(after, option);
            map.base_gain.y = take_float(after, option);
        } else if (option == "-clamp")
            map.clamp = take_switch(after, option);
        else if (option == "-blendu" || option == "-blendv")
            take_switch(after, option);
        else if (option == "-cc") {
            if (take_switch(after, option)) left_out.push_back("-cc");
        } else if (option == "-boost" || option == "-texres") {
            take_float(after, option);
            left_out.emplace_back(option);
        } else if (option == "-type")
            next_word(after);
        else if (option == "-imfchan") {
            const std::string_view channel = next_word(after);
            if (channel.size() != 1 || std::string_view("rgbmlz").find(channel[0]) == std::string_view::npos)
                throw InputError("{} after -imfchan, expected one of r g b m l z", shown(channel));
            map.channel = channel[0];
        } else
            break;  // a file name starting with a dash
        rest = trim(after);
    }
    if (rest.empty()) throw InputError("a texture map without a file");
    map.file = resolve_file(rest, folder);
    place(map);
    return map;
}

// Statements seen in one material.
struct Said {
    std::optional<float> d, tr;
    bool ns = false, ka = false, ks = false, ke = false, pr = false, pm = false, tf = false;
};

struct Reader {
    std::vector<Material>& materials;
    const fs::path& folder;
    const std::string& name;
    const Tr tr;
    Said said{};

    void statement(std::string_view rest) {
        const std::string written(next_word(rest)), keyword = lowercase(written);
        if (keyword == "newmtl") {
            if (trim(rest).empty()) throw InputError("newmtl without a name");
            finish();
            materials.emplace_back().name = trim(rest);
            said = {};
            return;
        }
        const bool known = color_of(keyword) || number_of(keyword) || map_of(keyword) || keyword == "d" ||
                           keyword == "tr" || keyword == "illum" || is_left_out(keyword);
        if (!known && materials.empty()) return;
        if (!known) return materials.back().left_out.push_back(written);
        if (materials.empty()) throw InputError("{} before the first newmtl", written);
        Material& m = materials.back();
        if (glm::vec3 Material::*color = color_of(keyword)) {
            if (const auto value = take_color(rest, written))
                m.*color = *value;
            else
                m.left_out.push_back(written + " as a spectrum or XYZ");
            said.tf |= keyword == "tf";
            said.ka |= keyword == "ka";
            said.ks |= keyword == "ks";
            said.ke |= keyword == "ke";
        } else if (float Material::*number = number_of(keyword)) {
            m.*number = take_float(rest, written);
            said.ns |= keyword == "ns";
            said.pr |= keyword == "pr";
            said.pm |= keyword == "pm";
        } else if (TextureMap Material::*map = map_of(keyword)) {
            m.*map = take_map(rest, folder, m.left_out);
        } else if (keyword == "d") {
            std::string_view after = rest;
            if (next_word(after) == "-halo") rest = after;
            said.d = take_float(rest, written);
        } else if (keyword == "tr") {
            said.tr = take_float(rest, written);
        } else if (is_left_out(keyword)) {
            leave_out_unless_plain(m, written, rest);
        } else {
            const float model = take_float(rest, written);
            if (!(model >= 0.0f && model <= 10.0f)) throw InputError("illum must be an integer from 0 to 10");
            m.illumination = static_cast<int>(model);
        }
    }

    // After a material's last statement: combines statements that depend on each other.
    void finish() {
        if (materials.empty()) return;
        Material& m = materials.back();
        set_opacity(m);
        if (said.tf && m.opacity < 1 && m.illumination < 3) m.illumination = 4;  // a filter of light: glass
        set_colors(m);
        set_transmission(m);
        m.has_exponent = said.ns && said.ks;
        const bool has_maps = m.roughness_map || m.metalness_map;
        m.metallic_roughness = m.microfacets = said.pr || said.pm || has_maps;
        if (has_maps) m.has_exponent = false;  // one exponent cannot say it
        if (m.roughness_map && !said.pr) m.roughness = 1;
        if (m.metalness_map && !said.pm) m.metalness = 1;
        if (m.emissive_map && !said.ke) m.emissive = glm::vec3(1);
        m.unlit = m.illumination == 0;
        if (m.illumination == 1 && !m.metallic_roughness) {  // diffuse alone
            m.specular = glm::vec3(0);
            m.specular_map = m.shininess_map = {};
        }
        // Ambient light takes Kd. A grey Ka, or one of Kd's hue, is what programs write where they mean nothing by it.
        const bool is_grey = m.ambient.r == m.ambient.g && m.ambient.g == m.ambient.b;
        if (said.ka && !is_grey && glm::length(glm::cross(m.ambient, m.diffuse)) > 1e-3f) m.left_out.push_back("Ka");
        if (m.opacity_map && !m.opacity_map.channel) m.opacity_map.channel = alpha_if_any;
        if (m.ambient_map && m.ambient_map.file != m.diffuse_map.file) m.left_out.push_back("map_Ka");
        // Heights lie at the mesh's coordinates; roughness and metalness become one texture.
        if (m.displacement_map && !m.displacement_map.place.is_plain()) m.left_out.push_back("-s and -o of disp");
        if (m.roughness_map && m.metalness_map && m.roughness_map.place != m.metalness_map.place)
            m.left_out.push_back("-s and -o of map_Pm");
    }

    // An opaque material passes nothing to filter. White is no filter; black is what programs write where they mean
    // nothing by it.
    static void set_transmission(Material& m) {
        glm::vec3& tint = m.transmission;
        const bool is_filter = tint.r >= 0 && tint != glm::vec3(0) && tint != glm::vec3(1);
        const bool is_opaque = m.opacity >= 1 && !m.opacity_map;
        if (is_filter && is_opaque) m.left_out.push_back("Tf of an opaque material");
        if (!is_filter || is_opaque) tint = Material{}.transmission;
    }

    // Programs disagree on the meaning of Tr; d is unambiguous.
    void set_opacity(Material& m) const {
        if (said.d) m.opacity = *said.d;
        if (said.d || !said.tr) return;
        m.opacity = tr == Tr::opacity ? *said.tr : 1.0f - *said.tr;
        if (tr != Tr::safe || m.opacity > 0.0f) return;
        m.opacity = 1;
        warn("{}: material '{}': Tr {:g} would make it vanish; drawn opaque, unless --set mtl.tr=transparency", name,
             m.name, *said.tr);
    }

    // 0 to 1; some programs count to 255, and some write black beside a texture.
    void set_colors(Material& m) const {
        if (m.diffuse_map && m.diffuse == glm::vec3(0.0f)) {
            m.diffuse = glm::vec3(1);
            warn("{}: material '{}': Kd 0 0 0 would make its map_Kd black; taken as 1 1 1", name, m.name);
        }
        for (glm::vec3 Material::*color :
             {&Material::ambient, &Material::diffuse, &Material::specular, &Material::transmission}) {
            glm::vec3& c = m.*color;
            const float most = std::max({c.r, c.g, c.b});
            if (!(most > 1.0f)) continue;
            c = most > 2.0f && most <= 255.0f ? c / 255.0f : glm::min(c, 1.0f);
            warn("{}: material '{}': a colour of {:g}, expected at most 1; taken as {:g}", name, m.name, most,
                 std::max({c.r, c.g, c.b}));
        }
    }

    static bool is_left_out(const std::string& k) {
        static const std::set<std::string> known = {"refl",  "ps",     "pc",     "pcr",    "aniso",  "anisor",
                                                    "decal", "map_ps", "map_tr", "map_tf", "map_pc", "map_refl"};
        return known.contains(k);
    }

    // Not where its numbers say that there is nothing to draw: all 0.
    static void leave_out_unless_plain(Material& m, const std::string& written, std::string_view rest) {
        bool plain = true;
        for (std::string_view word; !(word = next_value(rest)).empty();) {
            float value = 0;
            plain = plain && parse_float(word, value) == FloatStatus::ok && value == 0.0f;
        }
        if (!plain) m.left_out.push_back(written);
    }

    static glm::vec3 Material::*color_of(const std::string& k) {
        return k == "ka"   ? &Material::ambient
               : k == "kd" ? &Material::diffuse
               : k == "ks" ? &Material::specular
               : k == "ke" ? &Material::emissive
               : k == "tf" ? &Material::transmission
                           : nullptr;
    }
    static float Material::*number_of(const std::string& k) {
        return k == "ns"   ? &Material::shininess
               : k == "ni" ? &Material::refraction
               : k == "pr" ? &Material::roughness
               : k == "pm" ? &Material::metalness
                           : nullptr;
    }
    static TextureMap Material::*map_of(const std::string& k) {
        static const std::map<std::string, TextureMap Material::*> maps = {
            {"map_ka", &Material::ambient_map},      {"map_kd", &Material::diffuse_map},
            {"map_ks", &Material::specular_map},     {"map_ke", &Material::emissive_map},
            {"map_ns", &Material::shininess_map},    {"map_d", &Material::opacity_map},
            {"map_opacity", &Material::opacity_map}, {"map_bump", &Material::bump_map},
            {"bump", &Material::bump_map},           {"norm", &Material::normal_map},
            {"map_normal", &Material::normal_map},   {"map_kn", &Material::normal_map},
            {"disp", &Material::displacement_map},   {"map_disp", &Material::displacement_map},
            {"map_pr", &Material::roughness_map},    {"map_pm", &Material::metalness_map}};
        const auto it = maps.find(k);
        return it == maps.end() ? nullptr : it->second;
    }
};

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::string& name, const fs::path& folder, Tr tr) {
    text = without_mark(text);
    while (text.ends_with('\0')) text.remove_suffix(1);
    if (text.substr(0, 4096).find('\0') != text.npos)
        throw InputError("{}:1: the file is binary, expected MTL text", name);
    check_line_ends(text, name);
    std::vector<Material> materials;
    Reader reader{materials, folder, name, tr};
    Statements statements(text);
    for (std::string_view statement; statements.next(statement);) try {
            reader.statement(statement);
        } catch (const InputError& error) { fail_at(name, statements.line(), error.what()); }
    reader.finish();
    for (Material& material : materials) limit_numbers(material, name);
    return materials;
}

std::vector<Material> load_mtl(const fs::path& path, Tr tr) {
    return parse_mtl(read_file(path), path.string(), path.parent_path(), tr);
}

std::vector<Material> find_materials(const std::vector<std::string>& names, const std::vector<std::string>& libraries,
                                     const fs::path& folder, Tr tr) {
    std::map<std::string, Material> known;
    for (const std::string& written : libraries)
        for (const fs::path& file : resolve_files(written, folder)) {
            std::error_code ignored;
            if (!fs::is_regular_file(file, ignored)) {
                warn("{}: no such material file; its materials are plain", file.string());
                continue;
            }
            for (Material& material : load_mtl(file, tr)) known.try_emplace(material.name, std::move(material));
        }
    std::vector<Material> found;
    for (const std::string& name : names) {
        const auto it = known.find(name);
        if (it == known.end() && !known.empty()) warn("no material '{}' in the material files; it is plain", name);
        Material& material = found.emplace_back();
        if (it != known.end()) material = it->second;
        material.name = name;
    }
    return found;
}

}  // namespace lightwalk
