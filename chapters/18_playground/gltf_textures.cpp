#include "18_playground/gltf_textures.h"

#include <algorithm>
#include <cmath>

#include "common/image/decode.h"
#include "common/image/mip_levels.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

using json = GltfWriter::json;

bool is_png(std::span<const std::byte> file) { return file.size() > 3 && file[1] == std::byte{'P'}; }
bool is_jpeg(std::span<const std::byte> file) { return file.size() > 3 && file[0] == std::byte{0xFF}; }

// glTF 2.0, 3.8.3: PNG or JPEG.
bool is_allowed(const TextureMap& map) {
    if (map.bytes) return is_png(*map.bytes) || is_jpeg(*map.bytes);
    const std::string ending = map.file.extension().string();
    static const std::set<std::string> allowed{".png", ".PNG", ".jpg", ".JPG", ".jpeg", ".JPEG"};
    return allowed.contains(ending);
}

// Characters other than letters, digits and -._~/ as %NN.
std::string escaped(const std::string& text) {
    std::string uri;
    for (const unsigned char c : text)
        uri += std::isalnum(c) || std::string_view("-._~/").find(char(c)) != std::string_view::npos
                   ? std::string(1, char(c))
                   : fmt::format("%{:02X}", c);
    return uri;
}

// Of a turn and a scale: columns sx (c, -s) and sy (s, c).
json transform_of(const MapPlace& place) {
    const float along = glm::length(place.turn[0]);
    return {{"offset", {place.offset.x, place.offset.y}},
            {"rotation", std::atan2(-place.turn[0].y, place.turn[0].x)},
            {"scale", {along, along > 0 ? glm::determinant(place.turn) / along : 1.0f}}};
}

// At the centre of a texel of an image of another size; between its own texels linear, and it repeats.
glm::vec4 sampled(const Image8& image, int x, int y, int width, int height) {
    const glm::vec2 at{(float(x) + 0.5f) * float(image.width) / float(width) - 0.5f,
                       (float(y) + 0.5f) * float(image.height) / float(height) - 0.5f};
    const glm::ivec2 low(glm::floor(at));
    const auto texel = [&](int right, int down) {
        return glm::vec4(
            image.at((low.x + right + image.width) % image.width, (low.y + down + image.height) % image.height));
    };
    const glm::vec2 part = at - glm::vec2(low);
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
}

}  // namespace

int GltfTextures::image(const TextureUse& use) {
    const std::string key = use.key();
    if (const auto known = images_.find(key); known != images_.end()) return known->second;
    const TextureMap& map = use.map;
    json own;
    if (use.as != TextureUse::As::stored || map.channel || map.base_gain != glm::vec2(0, 1) || !is_allowed(map)) {
        const fs::path file = beside(fmt::format("made{}", images_.size()));
        writer_.files[file] = encode_png(picture_of(use));
        own["uri"] = uri_of(file);
    } else if (map.bytes) {
        own["bufferView"] = writer_.view(*map.bytes);
        own["mimeType"] = is_png(*map.bytes) ? "image/png" : "image/jpeg";
    } else {
        own["uri"] = uri_of(map.file);
    }
    return images_[key] = writer_.push("images", own);
}

fs::path GltfTextures::beside(const std::string& what) const {
    fs::path file = writer_.target;
    file.replace_filename(fmt::format("{}.{}.png", writer_.target.stem().string(), what));
    return file;
}

std::string GltfTextures::uri_of(const fs::path& file) const {
    std::error_code error;
    const fs::path near = fs::relative(file, fs::absolute(writer_.target).parent_path(), error);
    return escaped((error || near.empty() ? file : near).generic_string());
}

json GltfTextures::texture(const TextureUse& use) {
    json own{{"source", image(use)}};
    if (use.map.sampler != Sampler{}) own["sampler"] = sampler(use.map.sampler);
    const std::string key = own.dump();
    auto [known, is_new] = textures_.try_emplace(key, 0);
    if (is_new) known->second = writer_.push("textures", own);
    json info{{"index", known->second}};
    const MapPlace& place = use.map.place;
    if (place.set > 0) info["texCoord"] = place.set;
    if (place.turn == glm::mat2(1.0f) && place.offset == glm::vec2(0.0f)) return info;
    writer_.extensions.insert("KHR_texture_transform");
    info["extensions"]["KHR_texture_transform"] = transform_of(flipped(place));
    return info;
}

json GltfTextures::texture(const std::optional<TextureUse>& color, const TextureUse& opacity) {
    fs::path& file = cutouts_[{color ? color->key() : "", opacity.key()}];
    if (file.empty()) {
        file = beside(fmt::format("cutout{}", cutouts_.size()));
        const Image8 colors = color ? picture_of(*color) : Image8(1, 1, glm::u8vec4(255));
        writer_.files[file] = encode_png(color_with_opacity(colors, picture_of(opacity)));
    }
    TextureMap map = color ? color->map : opacity.map;  // where it lies, and how it is sampled
    map.file = file;
    map.bytes = nullptr;
    map.image = -1;
    map.channel = 0;
    map.base_gain = {0, 1};
    return texture(TextureUse{.map = map});
}

int GltfTextures::sampler(const Sampler& from) {
    const auto wrap = [](Wrap w) { return w == Wrap::clamp ? 33071 : w == Wrap::mirror ? 33648 : 10497; };
    const bool nearest = from.filter == Filter::nearest;
    json own{{"wrapS", wrap(from.wrap)},
             {"wrapT", wrap(from.wrap_v.value_or(from.wrap))},
             {"magFilter", nearest ? 9728 : 9729},
             {"minFilter", from.max_lod == 0 ? (nearest ? 9728 : 9729)
                           : nearest         ? 9986
                                             : 9987}};
    const std::string key = own.dump();
    const auto [known, is_new] = samplers_.try_emplace(key, 0);
    if (is_new) known->second = writer_.push("samplers", own);
    return known->second;
}

Image8 picture_of(const TextureUse& use) {
    if (is_hdr_name(use.file())) return to_srgb8(read_image_linear(use.file()));
    const DecodedTexture texture = decode_texture(use);
    std::vector<std::byte> texels = texture.levels.at(0);
    if (texture.desc.format == VK_FORMAT_R16G16B16A16_SFLOAT) texels = srgb_codes(texels);
    Image8 picture(static_cast<int>(texture.desc.size.x), static_cast<int>(texture.desc.size.y));
    const size_t step = texels.size() / (4 * picture.pixels.size());  // of 16 bits the upper eight
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c)
            picture.pixels[i][c] = std::to_integer<uint8_t>(texels[(4 * i + size_t(c)) * step + step - 1]);
    return picture;
}

Image8 color_with_opacity(const Image8& colors, const Image8& alphas) {
    Image8 both(std::max(colors.width, alphas.width), std::max(colors.height, alphas.height));
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x) {
            glm::vec4 texel = sampled(colors, x, y, both.width, both.height);
            texel.a *= sampled(alphas, x, y, both.width, both.height).r / 255.0f;
            both.at(x, y) = glm::u8vec4(glm::round(texel));
        }
    return both;
}

}  // namespace lightwalk
