#include "common/gpu/hidden_blocks.h"

#include <spirv_cross/spirv.h>

#include <initializer_list>
#include <map>

#include "common/base/error.h"

namespace lightwalk {
namespace {

using Words = std::vector<uint32_t>;

constexpr size_t header_words = 5, bound_word = 3;

void add(Words& to, SpvOp op, std::initializer_list<uint32_t> operands) {
    to.push_back((static_cast<uint32_t>(operands.size()) + 1) << SpvWordCountShift | op);
    to.insert(to.end(), operands);
}

struct Declared {
    std::map<uint32_t, uint32_t> pointee;   // block type by pointer type
    std::map<uint32_t, uint32_t> block_of;  // block type by variable
    uint32_t integer = 0;
};

Declared read_declarations(const Words& spirv) {
    Declared result;
    for (size_t at = header_words; at < spirv.size(); at += spirv[at] >> SpvWordCountShift) {
        const uint32_t* const word = &spirv[at];
        const uint32_t op = word[0] & SpvOpCodeMask;
        if (op == SpvOpTypeInt && word[2] == 32 && word[3] == 0) result.integer = word[1];
        if (op == SpvOpTypePointer && word[2] == SpvStorageClassUniform) result.pointee[word[1]] = word[3];
        if (op == SpvOpVariable && word[3] == SpvStorageClassUniform)
            result.block_of[word[2]] = result.pointee[word[1]];
    }
    return result;
}

}  // namespace

void hide_blocks(Words& spirv) {
    Declared declared = read_declarations(spirv);
    if (declared.block_of.empty()) return;
    uint32_t& bound = spirv[bound_word];
    Words decorations, declarations;
    if (declared.integer == 0) add(declarations, SpvOpTypeInt, {declared.integer = bound++, 32, 0});
    const uint32_t one = bound++, none = bound++, pushed = bound++, to_pushed = bound++, to_index = bound++,
                   push = bound++;
    add(declarations, SpvOpConstant, {declared.integer, one, 1});
    add(declarations, SpvOpConstant, {declared.integer, none, 0});
    add(declarations, SpvOpTypeStruct, {pushed, declared.integer});
    add(declarations, SpvOpTypePointer, {to_pushed, SpvStorageClassPushConstant, pushed});
    add(declarations, SpvOpTypePointer, {to_index, SpvStorageClassPushConstant, declared.integer});
    add(declarations, SpvOpVariable, {to_pushed, push, SpvStorageClassPushConstant});
    add(decorations, SpvOpMemberDecorate, {pushed, 0, SpvDecorationOffset, 0});
    add(decorations, SpvOpDecorate, {pushed, SpvDecorationBlock});
    for (const auto& [variable, block] : declared.block_of) {
        const uint32_t array = bound++, to_array = bound++;
        add(declarations, SpvOpTypeArray, {array, block, one});
        add(declarations, SpvOpTypePointer, {to_array, SpvStorageClassUniform, array});
        add(declarations, SpvOpVariable, {to_array, variable, SpvStorageClassUniform});
    }

    Words result(spirv.begin(), spirv.begin() + header_words);
    add(result, SpvOpCapability, {SpvCapabilityUniformBufferArrayDynamicIndexing});
    bool decorated = false, is_declared = false;
    for (size_t at = header_words; at < spirv.size(); at += spirv[at] >> SpvWordCountShift) {
        const uint32_t* const word = &spirv[at];
        const uint32_t count = word[0] >> SpvWordCountShift, op = word[0] & SpvOpCodeMask;
        const bool of_block = op == SpvOpVariable && declared.block_of.count(word[2]);
        if (of_block) continue;  // declared again as an array
        if (!decorated && (op == SpvOpDecorate || op == SpvOpMemberDecorate)) {
            result.insert(result.end(), decorations.begin(), decorations.end());
            decorated = true;
        }
        if (!is_declared && op == SpvOpFunction) {
            result.insert(result.end(), declarations.begin(), declarations.end());
            is_declared = true;
        }
        const bool follows = op == SpvOpAccessChain || op == SpvOpInBoundsAccessChain;
        if (follows && declared.block_of.count(word[3])) {
            const uint32_t place = bound++, index = bound++;
            add(result, SpvOpAccessChain, {to_index, place, push, none});
            add(result, SpvOpLoad, {declared.integer, index, place});
            result.push_back((count + 1) << SpvWordCountShift | op);
            result.insert(result.end(), {word[1], word[2], word[3], index});
            result.insert(result.end(), word + 4, word + count);
            continue;
        }
        const bool loads = op == SpvOpLoad && declared.block_of.count(word[3]);
        if (loads) throw Failure("a shader reads a uniform block whole");
        result.insert(result.end(), word, word + count);
        if (op == SpvOpEntryPoint) {
            result[result.size() - count] += 1u << SpvWordCountShift;
            result.push_back(push);
        }
    }
    result[bound_word] = bound;
    spirv = std::move(result);
}

}  // namespace lightwalk
