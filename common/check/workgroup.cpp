#include "common/check/workgroup.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <regex>

#include "common/check/barriers.h"
#include "common/gpu/frame.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace {

// Orders: identity, reverse, two random permutations.
std::vector<uint32_t> orders() {
    std::vector<uint32_t> all;
    std::mt19937 random(7);
    for (uint32_t order = 0; order < workgroup_orders; ++order) {
        std::vector<uint32_t> one(workgroup_size);
        std::iota(one.begin(), one.end(), 0u);
        if (order == 1) std::reverse(one.begin(), one.end());
        if (order > 1)
            for (uint32_t i = workgroup_size - 1; i > 0; --i) std::swap(one[i], one[random() % (i + 1)]);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

// Prefixes the check's identifiers, so that answers cannot name them (common/course/check/glsl_answer.py).
std::string hidden(std::string text) {
    static const std::regex own(R"(\b(case_index|put_at|stands_for|given|puts|put|orders)\b)");
    return std::regex_replace(text, own, "check_$1");
}

// Separate buffer, since overruns of shared arrays could overwrite counters.
std::string counting(uint32_t counts) {
    if (counts == 0) return "";
    return "layout(scalar) buffer CountBuffer { uint check_counts[]; };\n"
           "void check_count(uint i) { atomicAdd(check_counts[(gl_WorkGroupID.x * gl_NumWorkGroups.y + "
           "gl_WorkGroupID.y) * " +
           std::to_string(counts) + "u + i], 1u); }\n";
}

// Replaces built-ins that would reveal the true index.
void replace_all(std::string& text, const std::string& old, const std::string& with) {
    for (size_t at = 0; (at = text.find(old, at)) != text.npos; at += with.size()) text.replace(at, old.size(), with);
}

}  // namespace

WorkgroupResults::WorkgroupResults(Gpu& gpu, const WorkgroupRun& run)
    : cases_(run.cases), stride_(run.puts + 1), counts_(run.counts) {
    const std::string size = std::to_string(workgroup_size);
    const std::string before = hidden(
        "uint case_index, put_at, stands_for;\n"
        "layout(scalar) readonly buffer GivenBuffer { uint given[]; };\n"
        "layout(scalar) writeonly buffer PutBuffer { uint puts[]; };\n"
        "void put(uint i, uint word) { puts[put_at + i] = word; }\n" +
        counting(counts_) + run.before);
    std::string text = flatten_text(before + "\n#include \"" + run.include + "\"\n", "probe", "99", run.macros).text;
    text = text.substr(text.find("#line 1 "));
    replace_all(text, "gl_LocalInvocationIndex", "check_stands_for");
    replace_all(text, "gl_LocalInvocationID", "uvec3(check_stands_for, 0, 0)");
    // The check's own barriers are not recorded.
    static const std::regex wait(R"(\bbarrier\b)");
    const std::string call = hidden(std::regex_replace(run.call, wait, "check_barrier"));
    text = "layout(local_size_x = " + size + ") in;\n" + traced_barriers() + text +
           hidden(
               "\nlayout(scalar) readonly buffer OrderBuffer { uint orders[]; };\nvoid main() {\n"
               "    uint local = orders[gl_WorkGroupID.y * " +
               size +
               "u + gl_LocalInvocationIndex];\n"
               "    stands_for = local;\n    case_index = gl_WorkGroupID.x;\n"
               "    put_at = ((gl_WorkGroupID.x * gl_NumWorkGroups.y + gl_WorkGroupID.y) * " +
               size + "u + local) * " + std::to_string(stride_) + "u;\n") +
           call + hidden("\nput(" + std::to_string(run.puts) + "u, check_barriers_passed);\n}\n");
    const Pipeline pipeline = compute({.shader = "workgroup", .macros = run.macros, .source = text});
    const Buffer given = gpu.upload("given", run.given), order = gpu.upload("orders", orders());
    words_.resize(size_t(run.cases) * workgroup_orders * workgroup_size * stride_);
    const Buffer results(gpu.device, {.name = "puts", .bytes = 4 * words_.size()});
    counted_.resize(size_t(run.cases) * workgroup_orders * std::max(counts_, 1u));
    const Buffer counters = gpu.upload("counts", counted_);
    Frame frame(gpu);
    frame.begin({1, 1}, 0.0f);
    frame.compute(run.include, {.reads = {counters}, .writes = {results, counters}}, [&](Compute& pass) {
        pass.use(pipeline).set("check_given", given).set("check_orders", order).set("check_puts", results);
        if (counts_ > 0) pass.set("check_counts", counters);
        pass.dispatch({run.cases, workgroup_orders, 1});
    });
    frame.end();
    std::memcpy(words_.data(), gpu.read_back(results).data(), 4 * words_.size());
    std::memcpy(counted_.data(), gpu.read_back(counters).data(), 4 * counted_.size());
}

std::string WorkgroupResults::barriers() const {
    for (uint32_t which = 0; which < cases_; ++which)
        for (uint32_t order = 0; order < workgroup_orders; ++order) {
            std::vector<uint32_t> passed;
            for (uint32_t local = 0; local < workgroup_size; ++local)
                passed.push_back(at(which, order, local, stride_ - 1));
            if (const std::string wrong = barriers_wrong(passed); !wrong.empty()) return wrong;
        }
    return "";
}

}  // namespace lightwalk
