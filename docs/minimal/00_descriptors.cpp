// Where descriptors live: draws with one of 1,024 textures each, bound in eight ways and timed, in Vulkan 1.3 alone.
//     00_descriptors SHADERS [DRAWS [ROUNDS [FILE.json]]]     100,000 draws, which is the most, and 11 rounds
// SHADERS is the folder with 00_descriptors.*.spv. Exit code 1: a failure, or a wrong picture.
// Several fields a line keep the structs of Vulkan short:
// clang-format off
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "00_device.h"
#include "00_ranges.h"

constexpr uint32_t textures = 1024;
uint32_t texture_of(uint32_t draw) { return draw * 2654435761u >> 22; }  // Knuth's multiplicative hash, of 10 bits
uint32_t color_of(uint32_t texture) { return 0xff400000 | texture >> 8 << 14 | (texture & 255); }  // ABGR, all differ

enum How { written, kept, sorted, pushed, offset, constant, indirect };

struct Way {
    const char *name, *shader;
    How how; bool possible = true;  // on this device
    uint32_t count = 1;            // of descriptors at binding 0
    VkDescriptorType second = {};  // at binding 1, if there is one
    VkDescriptorSetLayout set_layout{}; VkPipelineLayout layout{}; VkPipeline pipeline{}; VkDescriptorPool pool{};
    std::vector<VkDescriptorSet> sets{};
    VkCommandBuffer commands{};  // each way frees its own commands
    std::array<std::vector<double>, 3> ms{};  // to record; from the submission to the fence; on the GPU
};

uint32_t draws = 100000;
std::vector<Image> pictures;  // one image for each texture
Image layers, target;         // an image with a layer for each texture; what is drawn into
VkSampler sampler;
std::vector<uint32_t> entries;     // of each texture in the table
std::vector<uint32_t> by_texture;  // numbers of all draws, sorted by texture
uint32_t block_bytes;              // from one draw's uniform block to the next
Buffer blocks, indirect_draws, copy;
VkQueryPool timestamps; VkFence ended;

// [layout]
void make_layouts(Way& way) {
    const VkDescriptorSetLayoutBinding bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, way.count, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr},
        {1, way.second, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}};
    const VkDescriptorBindingFlags holes[] = {VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT, 0};
    const uint32_t used = way.second ? 2 : 1;
    const VkDescriptorSetLayoutBindingFlagsCreateInfo partly{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO, .bindingCount = used,
        .pBindingFlags = holes};
    way.set_layout = make(vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout, {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .pNext = way.count > 1 ? &partly : nullptr,
        .flags = way.how == pushed ? VkFlags{VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR} : 0,
        .bindingCount = used, .pBindings = bindings});
    const VkPushConstantRange index{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(uint32_t)};
    way.layout = make(vkCreatePipelineLayout, vkDestroyPipelineLayout, {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = 1, .pSetLayouts = &way.set_layout,
        .pushConstantRangeCount = way.how == constant ? 1u : 0u, .pPushConstantRanges = &index});
}
// [/layout]

// [allocate]
VkDescriptorSet allocate_set(const Way& way) {
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
        .descriptorPool = way.pool, .descriptorSetCount = 1, .pSetLayouts = &way.set_layout};
    VkDescriptorSet set;
    check(vkAllocateDescriptorSets(device, &info, &set), "vkAllocateDescriptorSets");
    return set;
}

struct Write {  // of a texture into an entry of binding 0; a table has several
    VkDescriptorImageInfo image;
    VkWriteDescriptorSet info;
    Write(VkDescriptorSet set, uint32_t entry, VkImageView view)
        : image{sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
          info{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .dstSet = set, .dstArrayElement = entry,
            .descriptorCount = 1, .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .pImageInfo = &image} {}
};

void write(const Write& one) { vkUpdateDescriptorSets(device, 1, &one.info, 0, nullptr); }
// [/allocate]

// [entries]
std::vector<uint32_t> entries_of_models() {  // a model has 1 to 32 textures, whose entries are a range
    Ranges table(table_entries);
    std::vector<uint32_t> found;
    for (uint32_t model = 0; found.size() < textures; ++model) {
        const uint32_t count = std::min(1 + 7 * model % 32, textures - static_cast<uint32_t>(found.size()));
        const uint32_t leaves = table.allocate(count + 3).value();  // another model, which is removed again
        const uint32_t first = table.allocate(count).value();
        table.free(leaves, count + 3);
        for (uint32_t i = 0; i < count; ++i) found.push_back(first + i);
    }
    return found;
}
// [/entries]

void make_sets(Way& way) {
    const uint32_t sets = way.how == written ? draws : way.how == kept || way.how == sorted ? textures : 1;
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, sets * way.count},
                                          {way.second, 1}};
    way.commands = make_commands();
    way.pool = make(vkCreateDescriptorPool, vkDestroyDescriptorPool, {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = sets,
        .poolSizeCount = way.second ? 2u : 1u, .pPoolSizes = sizes});
    if (way.how == written || way.how == pushed) return;
    for (uint32_t i = 0; i < sets; ++i) way.sets.push_back(allocate_set(way));
    const bool table = way.count > 1, layered = !table && sets == 1;
    if (layered) write({way.sets[0], 0, layers.view});
    else for (uint32_t i = 0; i < textures; ++i)
        write({way.sets[table ? 0 : i], table ? entries[i] : 0, pictures[i].view});
    if (!way.second) return;
    Buffer choices = blocks;
    if (way.how == indirect) {
        choices = make_buffer(draws * sizeof(uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        for (uint32_t i = 0; i < draws; ++i)
            reinterpret_cast<uint32_t*>(choices.bytes)[i] = layered ? texture_of(i) : entries[texture_of(i)];
    }
    const VkDescriptorBufferInfo buffer{choices.handle, 0, way.how == offset ? sizeof(uint32_t) : VK_WHOLE_SIZE};
    const VkWriteDescriptorSet info{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .dstSet = way.sets[0],
        .dstBinding = 1, .descriptorCount = 1, .descriptorType = way.second, .pBufferInfo = &buffer};
    vkUpdateDescriptorSets(device, 1, &info, 0, nullptr);
}

void record_draws(const Way& way, VkCommandBuffer commands) {
    const auto bind = [&](VkDescriptorSet set, uint32_t count = 0, const uint32_t* offset = nullptr) {
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, way.layout, 0, 1, &set, count, offset);
    };
    const auto draw = [&](uint32_t number) { vkCmdDraw(commands, 4, 1, 0, number); };
    if (way.how == written) {
        // [written]
        vkResetDescriptorPool(device, way.pool, 0);
        for (uint32_t i = 0; i < draws; ++i) {
            const VkDescriptorSet set = allocate_set(way);
            write({set, 0, pictures[texture_of(i)].view});
            bind(set);
            draw(i);
        }
        // [/written]
    } else if (way.how == kept) {
        // [kept]
        for (uint32_t i = 0; i < draws; ++i) {
            bind(way.sets[texture_of(i)]);
            draw(i);
        }
        // [/kept]
    } else if (way.how == sorted) {
        // [sorted]
        uint32_t bound = textures;  // none yet
        for (const uint32_t i : by_texture) {
            if (texture_of(i) != bound) bind(way.sets[bound = texture_of(i)]);
            draw(i);
        }
        // [/sorted]
    } else if (way.how == pushed) {
        // [pushed]
        static const auto push = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
            vkGetDeviceProcAddr(device, "vkCmdPushDescriptorSetKHR"));
        for (uint32_t i = 0; i < draws; ++i) {
            const Write one(VK_NULL_HANDLE, 0, pictures[texture_of(i)].view);
            push(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, way.layout, 0, 1, &one.info);
            draw(i);
        }
        // [/pushed]
    } else if (way.how == offset) {
        // [offset]
        for (uint32_t i = 0; i < draws; ++i) {
            const uint32_t at = i * block_bytes;
            bind(way.sets[0], 1, &at);
            draw(i);
        }
        // [/offset]
    } else if (way.how == constant) {
        // [constant]
        bind(way.sets[0]);
        for (uint32_t i = 0; i < draws; ++i) {
            vkCmdPushConstants(commands, way.layout, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(uint32_t),
                               &entries[texture_of(i)]);
            draw(i);
        }
        // [/constant]
    } else {
        // [indirect]
        bind(way.sets[0]);
        vkCmdDrawIndirect(commands, indirect_draws.handle, 0, draws, sizeof(VkDrawIndirectCommand));
        // [/indirect]
    }
}

void time_frame(Way& way) {
    const VkCommandBuffer commands = way.commands;
    const double start_ms = now_ms();
    begin(commands);
    vkCmdResetQueryPool(commands, timestamps, 0, 2);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_TOP_OF_PIPE_BIT, timestamps, 0);
    begin_rendering(commands, target);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, way.pipeline);
    record_draws(way, commands);
    vkCmdEndRendering(commands);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timestamps, 1);
    read_back(commands, target, copy);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const double recorded_ms = now_ms();
    submit(commands, ended);
    way.ms[0].push_back(recorded_ms - start_ms);
    way.ms[1].push_back(now_ms() - recorded_ms);
    way.ms[2].push_back(gpu_ms(timestamps));
    for (uint32_t i = 0; i < size.width * size.height; ++i) {
        const uint32_t expected = i < draws ? color_of(texture_of(i)) : 0;
        if (std::memcmp(copy.bytes + 4 * i, &expected, 4) != 0)
            throw std::runtime_error(std::string(way.name) + ": pixel " + std::to_string(i) + " is wrong");
    }
}

void make_draws() {
    by_texture.resize(draws);
    std::iota(by_texture.begin(), by_texture.end(), 0u);
    std::ranges::stable_sort(by_texture, {}, texture_of);
    block_bytes = std::max(static_cast<uint32_t>(about.properties.limits.minUniformBufferOffsetAlignment), 4u);
    blocks = make_buffer(VkDeviceSize(draws) * block_bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    indirect_draws = make_buffer(draws * sizeof(VkDrawIndirectCommand), VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
    for (uint32_t i = 0; i < draws; ++i) {
        const uint32_t texture = texture_of(i);
        const VkDrawIndirectCommand one{4, 1, 0, i};
        std::memcpy(blocks.bytes + i * block_bytes, &texture, sizeof texture);
        std::memcpy(indirect_draws.bytes + i * sizeof one, &one, sizeof one);
    }
}

void print(const std::vector<Way>& ways, int rounds, const char* file) {
    FILE* json = std::fopen(file, "w");
    if (!json) throw std::runtime_error(std::string(file) + " cannot be written");
    const std::string driver = std::string(about_driver.driverName) + " " + about_driver.driverInfo;
    double load = 0; getloadavg(&load, 1);  // of the machine
    std::printf("%s, %s; %u draws, %u textures, %d rounds, load %.1f\n%-25s%25s%25s%25s\n", about.properties.deviceName,
                driver.c_str(), draws, textures, rounds, load, "ms: median (quartiles)", "record", "to fence", "GPU");
    std::fprintf(json, R"({"chapter": "00_descriptors", "measured": "by this program", "device": "%s", "driver": "%s", )"
                 R"("draws": %u, "load": %.1f, "points": [)", about.properties.deviceName, driver.c_str(), draws, load);
    for (const Way& way : ways) {
        std::printf("%-25s%s", way.name, way.possible ? "" : "       not on this device");
        std::fprintf(json, "%s\n {\"method\": \"%s\"", &way == &ways[0] ? "" : ",", way.name);
        for (int k = 0; way.possible && k < 3; ++k) {
            const auto [median, q1, q3] = quartiles(way.ms[k]);
            const char* key[] = {"record_ms", "wait_ms", "gpu_ms"};
            std::printf("%9.2f (%6.2f–%6.2f)", median, q1, q3);
            std::fprintf(json, R"(, "%s": {"median": %.4f, "q1": %.4f, "q3": %.4f})", key[k], median, q1, q3);
        }
        std::printf("\n");
        std::fprintf(json, "}");
    }
    std::fprintf(json, "\n]}\n");
    std::fclose(json);
}

int main(int argc, char** argv) try {
    if (argc < 2 || argc > 5) throw std::runtime_error("usage: 00_descriptors SHADERS [DRAWS [ROUNDS [FILE.json]]]");
    if (argc > 2) draws = std::clamp(std::atoi(argv[2]), 1, 100000);
    const int rounds = argc > 3 ? std::max(std::atoi(argv[3]), 1) : 11;
    make_device();
    const VkCommandBuffer commands = make_commands();
    ended = make(vkCreateFence, vkDestroyFence, {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO});
    timestamps = make(vkCreateQueryPool, vkDestroyQueryPool, {.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
        .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = 2});
    constexpr VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    pictures = make_images(textures, {4, 4}, 1, usage);
    layers = make_images(1, {4, 4}, textures, usage)[0];
    fill(commands, ended, layers, textures, color_of);
    for (uint32_t i = 0; i < textures; ++i) fill(commands, ended, pictures[i], 1, [i](auto) { return color_of(i); });
    sampler = make(vkCreateSampler, vkDestroySampler, {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO});
    make_draws();
    target = make_images(1, size, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT)[0];
    copy = make_buffer(4 * size.width * size.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    entries = entries_of_models();
    constexpr VkDescriptorType block = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    constexpr VkDescriptorType list = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    std::vector<Way> ways{
        {"set written per draw", "ONE", written},
        {"push descriptor", "ONE", pushed, has_push},
        {"set per texture", "ONE", kept},
        {"set per texture, sorted", "ONE", sorted},
        {"layers, dynamic offset", "LAYERS_BY_OFFSET", offset, true, 1, block},
        {"layers, indirect", "LAYERS_BY_BUFFER", indirect, true, 1, list},
        {"table, push constant", "TABLE_BY_CONSTANT", constant, has_table, table_entries},
        {"table, indirect", "TABLE_BY_BUFFER", indirect, has_table, table_entries, list}};
    for (int round = -2; round < rounds; ++round)  // the first two warm up
        for (Way& way : ways) {
            if (!way.possible) continue;
            if (!way.pipeline) {
                make_layouts(way);
                way.pipeline = make_pipeline(way.layout, argv[1], way.shader);
                make_sets(way);
            }
            if (round == 0) way.ms = {};
            time_frame(way);
        }
    print(ways, rounds, argc > 4 ? argv[4] : "/dev/null");
    for (; !cleanup.empty(); cleanup.pop_back()) cleanup.back()();
} catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
}
