#include "common/app/module.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "common/app/target.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/turn.h"
#include "common/gpu/gpu_work.h"
#include "common/scene/mesh.h"

namespace lightwalk {

Module::Module(Module& owner, std::string name, std::string kind) : owner_(&owner), kind_(std::move(kind)) {
    path_ = owner.path_.empty() || name.empty() ? owner.path_ + name : owner.path_ + "." + name;
    if (kind_.empty()) kind_ = name;
    owner.members_.push_back({.module = this});
    owner.forget_macros();
}

Module::~Module() {
    if (!owner_) return;
    std::erase_if(owner_->members_, [this](const Member& m) { return m.module == this; });
    owner_->forget_macros();
}

KnobList Module::all_knobs() const {
    KnobList all;
    for (const Member& member : members_) {
        if (member.knob) {
            all.push_back(member.knob);
        } else {
            const KnobList more = member.module->all_knobs();
            all.insert(all.end(), more.begin(), more.end());
        }
    }
    return all;
}

void Module::forget_macros() {
    for (Module* module = this; module; module = module->owner_) {
        module->macros_.reset();
        module->own_.clear();
    }
}

// Kept from frame to frame: a pass asks all of its modules, and their texts are hundreds.
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
    gpu_work.macro_lists += !compiled_.empty();
    return *macros_;
}

// Member by member, the knob of that name. Both are mostly in one order: the search goes on behind the last one found.
std::vector<std::byte> Module::block(const Binding& binding) const {
    if (binding.name != (kind_.empty() ? std::string_view("knobs") : std::string_view(kind_))) return {};
    std::vector<std::byte> bytes(binding.bytes);
    if (own_.empty()) visit_own([&](const KnobBase& knob) { own_.push_back(&knob); });
    size_t next = 0;
    for (const BlockMember& member : binding.members) {
        const KnobBase* found = nullptr;
        for (size_t i = 0; i < own_.size() && !found; ++i, next = (next + 1) % own_.size())
            if (own_[next]->name == member.name) found = own_[next];
        if (!found)
            throw Failure("the shader's {}.{} is no knob of {}", binding.name, member.name,
                          path_.empty() ? "the chapter" : "the module " + path_);
        const KnobBase::Numbers numbers = found->numbers();
        if (numbers.count != member.components)
            throw Failure("the shader's {}.{} has {} components, the knob {}", binding.name, member.name,
                          member.components, numbers.count);
        for (size_t i = 0; i < numbers.count; ++i) {
            const uint32_t word = member.type == BlockMember::Type::number
                                      ? std::bit_cast<uint32_t>(numbers.values[i])
                                      : std::bit_cast<uint32_t>(static_cast<int32_t>(numbers.values[i]));
            std::memcpy(bytes.data() + member.offset + 4 * i, &word, 4);
        }
    }
    return bytes;
}

void Module::expand(std::vector<const Given*>& into) const {
    Given::expand(into);
    for (const Member& member : members_)
        if (member.module && owner_) member.module->expand(into);  // a chapter's modules are stated one by one
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
        Turn::begins(module.path());
        aside([] {});  // others need not wait for all of them
        module.prepare(gpu, scene);
    });
}

bool Module::any_animated() const {
    bool any = false;
    visit_used(*this, [&](const Module& module) { any |= module.animated(); });
    return any;
}

Gathering Module::longest_gathering() const {
    Gathering longest;
    visit_used(*this, [&](const Module& module) {
        if (const Gathering one = module.gathering(); one.frames > longest.frames) longest = one;
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

bool Module::any_model(const std::filesystem::path& file, Model& into) const {
    bool any = false;
    visit_used(*this, [&](const Module& module) { any = any || module.stands_for(file, into); });
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
