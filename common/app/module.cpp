#include "common/app/module.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "common/app/target.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/names.h"
#include "common/base/preparing.h"
#include "common/base/shared_lock.h"
#include "common/scene/mesh.h"

namespace lightwalk {

Module::Module(Module& owner, std::string name, std::string kind, SourceLocation where)
    : owner_(&owner), kind_(std::move(kind)) {
    path_ = owner.path_.empty() || name.empty() ? owner.path_ + name : owner.path_ + "." + name;
    const bool has_kind = !kind_.empty();
    if (!has_kind) kind_ = name;
    const auto fail = [&](std::string_view why) {
        throw Failure("{}: module '{}': {}", place_of(where), path_.empty() ? name : path_, why);
    };
    if (!name.empty() && !is_macro_word(name)) fail(a_macro_word);
    if (!kind_.empty() && !is_macro_word(kind_)) fail("its kind '" + kind_ + "' is no name for GLSL");
    if (kind_ == "knobs" || kind_ == "view") fail("the block '" + kind_ + "' is not a module's; take another name");
    // Parts of one thing may share its name (a scene and its surfaces), not two of a kind.
    for (const Member& other : owner.members_)
        if (has_kind && !name.empty() && other.module && other.module->path_ == path_ && other.module->kind_ == kind_)
            fail("another module has this name; give one another");
    if (!kind_.empty()) block_name_ = BindingName(kind_).hash;
    owner.members_.push_back({.module = this});
    owner.forget_macros();
}

Module::~Module() {
    if (!owner_) return;
    std::erase_if(owner_->members_, [this](const Member& m) { return m.module == this; });
    owner_->forget_macros();
}

const KnobList& Module::all_knobs() const {
    if (all_) return *all_;
    KnobList& all = all_.emplace();
    for (const Member& member : members_) {
        if (member.knob) {
            all.push_back(member.knob);
        } else {
            const KnobList& more = member.module->all_knobs();
            all.insert(all.end(), more.begin(), more.end());
        }
    }
    return all;
}

uint64_t Module::epoch() const {
    Hash hash;
    hash.add(Exercises::epoch());
    for (const Member& member : members_)
        if (member.module) {
            hash.add(member.module->epoch());
        } else {
            hash.add(member.knob->numbers());
            hash.add(member.knob->variant());
        }
    return hash.value;
}

void Module::forget_macros() {
    for (Module* module = this; module; module = module->owner_) {
        module->all_.reset();
        module->macros_.reset();
        module->blocks_.clear();
    }
}

// Cached: every pass queries all its modules.
Macros Module::macros() const {
    const auto same = [](const auto& one) { return one.first->variant() == one.second; };
    if (macros_ && std::ranges::all_of(compiled_, same)) return *macros_;
    macros_.emplace();
    compiled_.clear();
    visit_own([&](const KnobBase& knob) {
        if (knob.variants().empty()) return;
        knob.add_macros(*macros_);
        compiled_.emplace_back(&knob, knob.variant());
    });
    return *macros_;
}

// Cached by layout: every pass queries the values.
std::span<const std::byte> Module::block(const Binding& binding) const {
    if (binding.hash != block_name_) return {};
    auto block = std::ranges::find(blocks_, binding.layout, &Block::layout);
    if (block == blocks_.end()) {
        Block made{.layout = binding.layout, .bytes = std::vector<std::byte>(binding.bytes)};
        std::vector<const KnobBase*> own;
        visit_own([&](const KnobBase& knob) { own.push_back(&knob); });
        for (const BlockMember& member : binding.members) {
            const auto found = std::ranges::find(own, member.name, &KnobBase::name);
            if (found == own.end()) {
                std::vector<std::string> names;
                for (const KnobBase* knob : own)
                    if (knob->numbers().count > 0) names.push_back(knob->name);
                const std::vector<std::string> nearest = nearest_names(member.name, names, 1);
                throw Failure("the shader's {}.{} is no knob of {}{}", binding.name, member.name,
                              path_.empty() ? "the chapter" : "the module " + path_,
                              nearest.empty() ? ", which has none" : "; the nearest is " + nearest[0]);
            }
            if ((*found)->numbers().count == 0)
                throw Failure("the shader's {}.{} is compiled in: use its macro {}", binding.name, member.name,
                              (*found)->macro());
            if (const size_t count = (*found)->numbers().count; count != member.components)
                throw Failure("the shader's {}.{} has {} components, the knob {}", binding.name, member.name,
                              member.components, count);
            using Type = BlockMember::Type;
            if (member.type == Type::other)
                throw Failure("the shader's {}.{} is no float, int or uint, nor a vector of these", binding.name,
                              member.name);
            if (member.type != Type::number && !(*found)->is_integer())
                throw Failure(
                    "the shader's {}.{} is an integer and would cut off the knob's fraction; declare it float",
                    binding.name, member.name);
            made.knobs.push_back(*found);
        }
        block = blocks_.insert(block, std::move(made));
    }
    for (size_t m = 0; m < binding.members.size(); ++m) {
        const BlockMember& member = binding.members[m];
        const KnobBase::Numbers numbers = block->knobs[m]->numbers();
        for (size_t i = 0; i < numbers.count; ++i) {
            const uint32_t word = member.type == BlockMember::Type::number
                                      ? std::bit_cast<uint32_t>(numbers.values[i])
                                      : std::bit_cast<uint32_t>(static_cast<int32_t>(numbers.values[i]));
            std::memcpy(block->bytes.data() + member.offset + 4 * i, &word, 4);
        }
    }
    return block->bytes;
}

void Module::expand(std::vector<const PassInputs*>& into) const {
    PassInputs::expand(into);
    for (const Member& member : members_)
        if (member.module && owner_) member.module->expand(into);  // the chapter's modules are listed individually
}

void Module::begin_frame(Gpu& gpu, glm::uvec2 frame_size) {
    for (TargetBase* target : targets_) target->begin_frame(gpu, frame_size);
    for (const Member& member : members_)
        if (member.module) member.module->begin_frame(gpu, frame_size);
}

template <class Self, class Visit>
void Module::visit_used(Self& self, const Visit& visit) {
    if (self.in_use && !self.in_use()) return;
    for (const Member& member : self.members_)
        if (member.module) visit_used(static_cast<Self&>(*member.module), visit);
    visit(self);
}

void Module::prepare_all(Gpu& gpu, Scene& scene) {
    visit_used(*this, [&](Module& module) {
        unlocked([] {});  // yields to waiting threads
        if (!module.path().empty()) announce(module.path());
        module.prepare(gpu, scene);
    });
}

bool Module::any_animated() const {
    bool any = false;
    visit_used(*this, [&](const Module& module) { any |= module.animated(); });
    return any;
}

Accumulation Module::longest_accumulation() const {
    Accumulation longest;
    visit_used(*this, [&](const Module& module) {
        if (const Accumulation one = module.accumulation(); one.frames > longest.frames) longest = one;
    });
    return longest;
}

const Sound* Module::any_sound() const {
    const Sound* any = nullptr;
    visit_used(*this, [&](const Module& module) {
        if (!any) any = module.sound();
    });
    return any;
}

bool Module::any_proxy(const std::filesystem::path& file, Model& into) const {
    bool any = false;
    visit_used(*this, [&](const Module& module) { any = any || module.load_proxy(file, into); });
    if (any && into.materials.empty()) into.materials.emplace_back();
    return any;
}

std::vector<std::string> Module::all_status() const {
    std::vector<std::string> all;
    visit_used(*this, [&](const Module& module) {
        for (std::string& line : module.status()) all.push_back(std::move(line));
    });
    return all;
}

std::string Module::load_state() const {
    std::string state;
    visit_used(*this, [&](const Module& module) {
        if (module.in_use) state += module.path() + ";";
        if (const std::string key = module.load_key(); !key.empty()) state += key + ";";
        for (const std::string& id : module.load_exercises())
            state += id + (Exercises::uses_solution(id) ? "=solution;" : "=exercise;");
    });
    return state;
}

bool Module::loads_exercise() const {
    bool any = false;
    visit_used(*this, [&](const Module& module) {
        for (const std::string& id : module.load_exercises()) any |= !Exercises::uses_solution(id);
    });
    return any;
}

void Module::forget_history() {
    for (TargetBase* target : targets_) target->forget();
    for (const Member& member : members_)
        if (member.module) member.module->forget_history();
}

}  // namespace lightwalk
