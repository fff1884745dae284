// Modules: units of knobs, targets, passes and shaders that chapters share.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "common/app/knob.h"
#include "common/base/epoch.h"
#include "common/gpu/pass_inputs.h"

namespace lightwalk {

class Gpu;
class Scene;
struct Model;
struct Sound;
class TargetBase;

/// Temporal accumulation of a picture.
struct Accumulation {
    int frames = 0;                           ///< from cold start to final picture; 0: no accumulation
    glm::vec2 (*shift)(int frame) = nullptr;  ///< sub-pixel jitter per frame, -0.5 to 0.5 pixels
};

/// Owner of knobs, targets, passes and GLSL. Members register themselves:
///
///     struct Shadow : Module {
///         using Module::Module;
///         Choice filter{*this, "filter", {"hard", "pcf"}, "pcf", "shadow filter"};
///     };
///     Shadow shadow{*this, "shadow"};  // in a chapter or another module
///
/// Option and scene key: shadow.filter. In GLSL, names start with the module's kind (by default its name): the macro
/// SHADOW_FILTER, the uniform block `shadow`. Two modules of one kind have separate options and share shaders; a pass
/// accepts only one of them. A pass that lists a module in `.with` also receives the modules it owns.
class Module : public PassInputs {
  public:
    /// Without a name, members have the owner's path, macros and uniform block. Throws Failure, which names the
    /// statement `where`: a name that is no word, that another module of its kind has there, or that GLSL has otherwise.
    Module(Module& owner, std::string name, std::string kind = "", SourceLocation where = SourceLocation::current());
    ~Module() override;
    Module(const Module&) = delete;

    const std::string& kind() const override { return kind_; }
    const std::string& path() const { return path_; }  ///< "shadow", "lights.shadow"; empty: the chapter

    Macros macros() const override;
    std::span<const std::byte> block(const Binding& binding) const override;
    void expand(std::vector<const PassInputs*>& into) const override;

    /// Knobs of this module and its submodules, in declaration order.
    const KnobList& all_knobs() const;

    /// Number for the knobs of this module and its submodules, the exercises in use and the edits of shaders. It is the
    /// same again when a knob or an exercise is set back.
    uint64_t epoch() const;

    /// Start of a frame: resizes targets and swaps histories.
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size);

    /// Invalidates histories, after a change of scene or method.
    void forget_history();

    // Life cycle. The chapter visits all modules in declaration order, submodules first.

    /// Rebuilds everything derived from the scene, after it was loaded or reloaded.
    virtual void prepare(Gpu&, Scene&) {}

    /// True if the picture changes over time or accumulates over frames.
    virtual bool animated() const { return false; }

    /// Text key of prepare()'s dependencies beyond the scene; a change reloads the scene.
    virtual std::string load_key() const { return {}; }

    virtual Accumulation accumulation() const { return {}; }

    /// Exercises that run during loading: toggling one reloads the scene.
    virtual std::vector<std::string> load_exercises() const { return {}; }

    /// True if this module reads the file itself. `into` receives the proxy model for the scene, without triangles if
    /// the module draws it.
    virtual bool load_proxy(const std::filesystem::path& /*file*/, Model& /*into*/) const { return false; }

    /// Sound track of the window, from 0 s on; null: none. Valid until the next prepare().
    virtual const Sound* sound() const { return nullptr; }

    /// Status lines of the last frame, shown beside the pass times and by --timings.
    virtual std::vector<std::string> status() const { return {}; }

    /// False: prepare(), status() and the other visits skip this module and its submodules. Default: always in use.
    std::function<bool()> in_use;

    void prepare_all(Gpu& gpu, Scene& scene);
    bool any_animated() const;
    Accumulation longest_accumulation() const;
    bool any_proxy(const std::filesystem::path& file, Model& into) const;
    const Sound* any_sound() const;
    std::vector<std::string> all_status() const;
    std::string load_state() const;  ///< load keys and toggles of load exercises
    bool loads_exercise() const;     ///< an exercise that runs during loading is the student's

  protected:
    Module() = default;

  private:
    template <class Visit>
    void visit_own(const Visit& visit) const {
        for (const Member& member : members_)
            if (member.knob)
                visit(*member.knob);
            else if (member.module->kind_.empty())
                member.module->visit_own(visit);
    }
    void forget_macros();
    friend class KnobBase;
    friend class TargetBase;
    template <class Self, class Visit>
    static void visit_used(Self& self, const Visit& visit);
    Module* owner_ = nullptr;
    std::string path_, kind_;
    struct Member {  ///< exactly one is set
        KnobBase* knob = nullptr;
        Module* module = nullptr;
    };
    std::vector<Member> members_;
    std::vector<TargetBase*> targets_;
    mutable std::optional<KnobList> all_;
    mutable std::optional<Macros> macros_;
    mutable std::vector<std::pair<const KnobBase*, size_t>> compiled_;  ///< variants in macros_
    struct Block {
        uint64_t layout = 0;
        std::vector<const KnobBase*> knobs{};
        std::vector<std::byte> bytes{};
    };
    mutable std::vector<Block> blocks_;
    uint64_t block_name_ = BindingName("knobs").hash;
};

}  // namespace lightwalk
