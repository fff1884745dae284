#include "07_mipmaps/level_view.h"

#include "07_mipmaps/truth.h"

namespace lightwalk {

void LevelView::record(Frame& frame, const LevelledMaps& maps, const MipChain& chain) {
    const size_t index = std::min(static_cast<size_t>(texture.value), maps.entries().size() - 1);
    const LevelledMaps::Entry& entry = *maps.entries()[index];
    const uint32_t m = std::min(static_cast<uint32_t>(level.value), entry.levels.desc.mips - 1);
    // The reference does not depend on a wrong choice of content.
    if (shown_ != &entry || shown_level_ != m) {
        const glm::uvec2 size(entry.levels.mip(m).size());
        truth::Texels exact = decoded(read_texels(frame.gpu, entry.plain), entry.content);
        exact = truth::area_mean(exact, size);
        for (glm::dvec4& texel : exact.values) texel = truth::encode(entry.content, texel);
        exact_ =
            Image(frame.gpu.device, {.name = "exact level", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = size});
        frame.gpu.upload(exact_, to_bytes(exact, exact_.desc.format));
        shown_ = &entry;
        shown_level_ = m;
        text_ = fmt::format("{}: level {}, {}x{}", entry.name, m, size.x, size.y);
    }
    const ImageView found = (chain.method.is("none") ? entry.plain.mip(0) : entry.levels.mip(m)).codes();
    frame.compute("level", {.reads = {found}, .writes = {frame.hdr}, .with = {*this}}, [&](Compute& pass) {
        pass.use(show_).set("found", found, nearest_clamp).set("exact", exact_, nearest_clamp);
        pass.set("result", frame.hdr).dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
