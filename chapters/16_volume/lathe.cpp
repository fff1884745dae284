#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "16_volume/finish.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

using Json = nlohmann::json;

/// The keys of a .lathe file, each read once.
class Keys {
  public:
    Keys(std::string where, const Json& json) : where_(std::move(where)), json_(json) {}

    template <class T>
    void number(const char* key, T& value, double least, double most) {
        known_.push_back(key);
        if (!json_.contains(key)) return;
        const Json& found = json_.at(key);
        if (!found.is_number() || found.get<double>() < least || found.get<double>() > most)
            throw InputError("{}: key '{}' must be a number from {:g} to {:g}", where_, key, least, most);
        value = found.get<T>();
    }
    void color(const char* key, glm::vec3& value) {
        known_.push_back(key);
        if (!json_.contains(key)) return;
        const Json& found = json_.at(key);
        if (!is_numbers(found, 3)) throw InputError("{}: key '{}' must be three numbers from 0 to 1", where_, key);
        for (int i = 0; i < 3; ++i) value[i] = std::clamp(found[static_cast<size_t>(i)].get<float>(), 0.0f, 1.0f);
    }
    void profile(std::vector<glm::vec2>& points, std::vector<int>& rows) {
        for (const char* key : {"profile", "rows"}) {
            known_.push_back(key);
            if (!json_.contains(key) || !json_.at(key).is_array())
                throw InputError("{}: key '{}' must be a list", where_, key);
        }
        for (const Json& point : json_.at("profile")) {
            if (!is_numbers(point, 2))
                throw InputError("{}: key 'profile' must be a list of [distance, height]", where_);
            points.emplace_back(point[0].get<float>(), point[1].get<float>());
            if (!(points.back().x > 0) || glm::length(points.back()) > 1e4f)
                throw InputError("{}: key 'profile': distances must be above 0 and no farther than 10,000 m", where_);
        }
        for (const Json& row : json_.at("rows")) {
            if (!row.is_number_integer() || row.get<int>() < 1 || row.get<int>() > 64)
                throw InputError("{}: key 'rows' must be integers from 1 to 64", where_);
            rows.push_back(row.get<int>());
        }
    }
    void flag(const char* key, bool& value) {
        known_.push_back(key);
        if (!json_.contains(key)) return;
        if (!json_.at(key).is_boolean()) throw InputError("{}: key '{}' must be true or false", where_, key);
        value = json_.at(key).get<bool>();
    }
    void nothing_else() const {
        for (const auto& [key, value] : json_.items())
            if (std::find(known_.begin(), known_.end(), key) == known_.end())
                throw InputError("{}: unknown key '{}'", where_, key);
    }

  private:
    static bool is_numbers(const Json& json, size_t count) {
        return json.is_array() && json.size() == count &&
               std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_number(); });
    }
    std::string where_;
    const Json& json_;
    std::vector<std::string> known_;
};

/// A part of the profile, straight from one point to the next.
struct Stretch {
    glm::vec2 from, to, normal;
    float v_from, v_to;
};

std::vector<Stretch> parts_of(const Lathe& lathe) {
    std::vector<Stretch> parts;
    float length = 0;
    for (size_t i = 0; i < lathe.rows.size(); ++i) {
        const glm::vec2 from = lathe.profile[i], to = lathe.profile[(i + 1) % lathe.profile.size()], way = to - from;
        const float more = glm::length(way);
        parts.push_back({from, to, glm::vec2(way.y, -way.x) / more, length, length + more});
        length += more;
    }
    for (Stretch& part : parts) {
        part.v_from /= length;
        part.v_to /= length;
    }
    return parts;
}

/// One panel: a lattice of 4 lines across and as many as needed along, with raised inner ones.
struct Block {
    const Stretch& part;
    float from, to;      ///< share of the part, across
    double first, last;  ///< angles, radians
    int cells;
    float rise_m, bevel_m;
};

glm::vec3 around(glm::vec2 place, double angle) {
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    return {place.x * c, place.y, place.x * s};
}

void add_block(const Block& block, uint32_t panel, std::vector<LatheQuad>& quads) {
    const Stretch& part = block.part;
    const float length = glm::length(part.to - part.from);
    const float across_bevel = std::min(block.bevel_m / length, 0.3f * (block.to - block.from));
    const float across[] = {block.from, block.from + across_bevel, block.to - across_bevel, block.to};
    const double radius = static_cast<double>(0.5f * (part.from.x + part.to.x)),
                 cell = (block.last - block.first) / block.cells;
    const double along_bevel = std::min(static_cast<double>(block.bevel_m) / radius, 0.3 * cell);
    std::vector<double> along{block.first, block.first + along_bevel};
    for (int i = 1; i < block.cells; ++i) along.push_back(block.first + i * cell);
    along.insert(along.end(), {block.last - along_bevel, block.last});
    const size_t columns = along.size() - 1;
    const auto place = [&](size_t i, size_t j) {
        const bool inside = i > 0 && i < columns && j > 0 && j < 3;
        const glm::vec2 at = glm::mix(part.from, part.to, across[j]) + (inside ? block.rise_m : 0.0f) * part.normal;
        return around(at, along[i]);
    };
    for (size_t i = 0; i < columns; ++i)
        for (size_t j = 0; j < 3; ++j) {
            LatheQuad quad;
            const size_t corner[4][2] = {{i, j}, {i, j + 1}, {i + 1, j + 1}, {i + 1, j}};
            quad.is_top = i > 0 && i + 1 < columns && j == 1;
            for (int k = 0; k < 4; ++k) {
                quad.position[k] = place(corner[k][0], corner[k][1]);
                quad.normal[k] = around(part.normal, along[corner[k][0]]);
            }
            if (!quad.is_top) {
                const glm::vec3 face =
                    glm::cross(quad.position[2] - quad.position[0], quad.position[3] - quad.position[1]);
                for (glm::vec3& normal : quad.normal) normal = glm::normalize(face);
            }
            const auto u = [](double angle) { return static_cast<float>(angle / glm::two_pi<double>()); };
            quad.lower = {u(along[i]), glm::mix(part.v_from, part.v_to, across[j])};
            quad.upper = {u(along[i + 1]), glm::mix(part.v_from, part.v_to, across[j + 1])};
            quad.panel = panel;
            quads.push_back(quad);
        }
}

}  // namespace

bool is_lathe_file(const std::filesystem::path& file) { return file.extension() == ".lathe"; }

Lathe read_lathe(const std::filesystem::path& file) {
    const std::string where = file.string();
    const Json json = Json::parse(read_file(file, size_t{1} << 20), nullptr, false);
    if (!json.is_object())
        throw InputError("{}: not JSON: expected {{\"profile\": [[1, 0], ...], \"rows\": [2, ...]}}", where);
    Lathe lathe;
    Keys keys(where, json);
    keys.profile(lathe.profile, lathe.rows);
    keys.flag("closed", lathe.closed);
    keys.number("columns", lathe.columns, 8, 1024);
    keys.number("longest", lathe.longest, 1, 32);
    keys.number("relief_m", lathe.relief_m, 0, 1);
    keys.number("bevel_m", lathe.bevel_m, 1e-4, 1);
    keys.number("glow", lathe.glow, 0, 1);
    keys.number("glow_strength", lathe.glow_strength, 0, 1e4);
    keys.number("seed", lathe.seed, 0, 1e6);
    keys.color("albedo", lathe.albedo);
    keys.color("second", lathe.second);
    keys.color("specular", lathe.specular);
    keys.color("second_specular", lathe.second_specular);
    keys.color("glow_color", lathe.glow_color);
    keys.nothing_else();
    const size_t joins = lathe.profile.size() - (lathe.closed ? 0u : 1u);
    if (lathe.profile.size() < 3 || lathe.rows.size() != joins)
        throw InputError("{}: key 'rows' must have one number for each of the profile's {} parts", where, joins);
    for (size_t i = 0; i < joins; ++i)
        if (glm::distance(lathe.profile[i], lathe.profile[(i + 1) % lathe.profile.size()]) < 1e-5f)
            throw InputError("{}: key 'profile': point {} stands where the next one does", where, i);
    return lathe;
}

LatheParts turn_lathe(const Lathe& lathe) {
    LatheParts made;
    std::mt19937 random(static_cast<unsigned>(lathe.seed));
    // No std::uniform_real_distribution: each library has another.
    const auto share = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    const std::vector<Stretch> parts = parts_of(lathe);
    const double cell = glm::two_pi<double>() / lathe.columns;
    for (size_t p = 0; p < parts.size(); ++p)
        for (int row = 0; row < lathe.rows[p]; ++row)
            for (int column = 0; column < lathe.columns;) {
                const int cells =
                    std::min(1 + static_cast<int>(share() * static_cast<float>(lathe.longest)), lathe.columns - column);
                const auto rows = static_cast<float>(lathe.rows[p]);
                Block block{parts[p],
                            static_cast<float>(row) / rows,
                            static_cast<float>(row + 1) / rows,
                            column * cell,
                            (column + cells) * cell,
                            cells,
                            0,
                            lathe.bevel_m};
                LathePanel panel;
                panel.glows = share() < lathe.glow;
                panel.is_second = share() < 0.28f;
                panel.shade = 0.6f + 0.6f * share();
                panel.gloss = 0.35f + 0.5f * share();
                const float rise = share();
                block.rise_m = panel.glows ? -0.5f * lathe.relief_m
                                           : lathe.relief_m * (rise < 0.2f ? -rise * 3 : 0.25f + 0.75f * rise);
                add_block(block, static_cast<uint32_t>(made.panels.size()), made.quads);
                panel.lower = {static_cast<float>(column) / static_cast<float>(lathe.columns),
                               glm::mix(parts[p].v_from, parts[p].v_to, block.from)};
                panel.upper = {static_cast<float>(column + cells) / static_cast<float>(lathe.columns),
                               glm::mix(parts[p].v_from, parts[p].v_to, block.to)};
                made.panels.push_back(panel);
                column += cells;
            }
    return made;
}

Model lathe_model(const Lathe& lathe, const LatheParts& parts) {
    Model model;
    Mesh mesh;
    mesh.name = "lathe";
    for (const LatheQuad& quad : parts.quads) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        const glm::vec2 uv[4] = {quad.lower, {quad.lower.x, quad.upper.y}, quad.upper, {quad.upper.x, quad.lower.y}};
        for (int k = 0; k < 4; ++k) {
            mesh.vertices.push_back({quad.position[k], quad.normal[k], uv[k]});
            mesh.bounds.add(quad.position[k]);
        }
        for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + corner);
    }
    mesh.parts.push_back({0, static_cast<uint32_t>(mesh.indices.size()), 0});
    Material material;
    material.name = "panels";
    material.diffuse = material.specular = glm::vec3(1.0f);  // the maps say the rest
    material.emissive = glm::vec3(lathe.glow_strength);
    model.materials.push_back(material);
    model.meshes.push_back(std::move(mesh));
    model.nodes.push_back({.name = "lathe", .parent = -1, .local = glm::mat4(1.0f), .meshes = {0}});
    return model;
}

}  // namespace lightwalk
