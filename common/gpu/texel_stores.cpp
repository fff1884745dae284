#include "common/gpu/texel_stores.h"

#include <spirv_cross/spirv.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace lightwalk {
namespace {

class Indices {
  public:
    void read(const uint32_t* word, uint32_t count) {
        switch (word[0] & SpvOpCodeMask) {
            case SpvOpDecorate:
                if (word[2] == SpvDecorationBuiltIn &&
                    (word[3] == SpvBuiltInGlobalInvocationId || word[3] == SpvBuiltInFragCoord))
                    thread_ = word[1];
                break;
            case SpvOpVariable:
                if (count > 4) store(word[2], word[4]);
                break;
            case SpvOpStore:
                store(word[1], word[2]);
                break;
            case SpvOpLoad:
            case SpvOpBitcast:
            case SpvOpConvertSToF:
            case SpvOpConvertUToF:
                from_[word[2]] = word[3];
                break;
            case SpvOpConstant:
            case SpvOpConstantComposite:
                constants_.insert(word[2]);
                break;
            case SpvOpCompositeConstruct:
                if (std::all_of(word + 3, word + count, [&](uint32_t id) { return constants_.contains(id); }))
                    constants_.insert(word[2]);
                break;
            case SpvOpFAdd:
                if (constants_.contains(word[4])) from_[word[2]] = word[3];
                break;
            case SpvOpImageSampleImplicitLod:
            case SpvOpImageSampleExplicitLod:
            case SpvOpImageGather:
                samples_.emplace_back(from_[word[3]], word[4]);
                break;
            case SpvOpVectorShuffle:
                if (word[5] == 0 && word[6] == 1) from_[word[2]] = word[3];
                break;
            case SpvOpAccessChain:
                whole_[word[2]] = word[3];
                break;
            case SpvOpFunctionCall:
            case SpvOpImageTexelPointer:
                for (uint32_t i = 3; i < count; ++i) others_.insert(whole(word[i]));
                break;
            case SpvOpImageWrite:
                writes_.emplace_back(from_[word[1]], word[2]);
                break;
            default:
                break;
        }
    }

    TexelAccess images() const {
        TexelAccess result;
        std::unordered_set<uint32_t> elsewhere = others_;
        for (const auto& [image, index] : writes_)
            (is_thread(index) ? result.stored_by_thread : elsewhere).insert(image);
        std::erase_if(result.stored_by_thread, [&](uint32_t id) { return elsewhere.contains(id); });
        for (const auto& [image, coordinates] : samples_)
            if (is_thread(coordinates)) result.sampled_at_pixels.insert(image);
        return result;
    }

  private:
    uint32_t whole(uint32_t pointer) const {
        const auto found = whole_.find(pointer);
        return found == whole_.end() ? pointer : found->second;
    }

    void store(uint32_t pointer, uint32_t value) {
        const bool is_first = from_.emplace(pointer, value).second;
        if (!is_first || whole_.contains(pointer)) others_.insert(whole(pointer));
    }

    bool is_thread(uint32_t id) const {
        constexpr int longest = 32;  // ends at a variable that is stored to itself
        for (int step = 0; step < longest && id != thread_; ++step) {
            const auto found = from_.find(id);
            if (found == from_.end() || others_.contains(id)) return false;
            id = found->second;
        }
        return id == thread_;
    }

    uint32_t thread_ = 0;                           // gl_GlobalInvocationID or gl_FragCoord
    std::unordered_map<uint32_t, uint32_t> from_;   // a value's source; of a variable its only value
    std::unordered_map<uint32_t, uint32_t> whole_;  // variables of pointers to a part
    std::unordered_set<uint32_t> others_;           // variables that are stored to twice, or used otherwise
    std::unordered_set<uint32_t> constants_;
    std::vector<std::pair<uint32_t, uint32_t>> writes_, samples_;  // image and index, or coordinates
};

}  // namespace

TexelAccess texel_access(const std::vector<uint32_t>& spirv) {
    Indices indices;
    constexpr size_t header_words = 5;
    for (size_t at = header_words; at < spirv.size(); at += std::max(spirv[at] >> SpvWordCountShift, 1u))
        indices.read(&spirv[at], spirv[at] >> SpvWordCountShift);
    return indices.images();
}

}  // namespace lightwalk
