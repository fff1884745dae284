// Modules: the unit that one chapter hands to the next, under one name.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "common/app/knob.h"
#include "common/base/epoch.h"
#include "common/gpu/given.h"

namespace lightwalk {

class Gpu;
class Scene;
struct Model;
struct Sound;
class TargetBase;

/// How a picture is gathered over frames.
struct Gathering {
    int frames = 0;  ///< that a cold start takes until the picture counts; 0: each stands alone
    glm::vec2 (*shift)(int frame) = nullptr;  ///< of each frame within a pixel: -0.5 to 0.5
};

// [module]
/// An owner of knobs, targets, passes and GLSL. Its members register with it in their constructors:
///
///     struct Shadow : Module {
///         using Module::Module;
///         Choice filter{*this, "filter", {"hard", "pcf"}, "pcf", "how the shadow is filtered"};
///     };
///     Shadow shadow{*this, "shadow"};  // in a chapter, or in another module
///
/// The option and scene key is shadow.filter. In GLSL the kind, which is the name unless it is given, stands before all
/// it has: the macro SHADOW_FILTER, the uniform block `shadow`. So two modules of one kind have different options and
/// share their shaders; a pass takes one of them. A pass that states it in `.with` is given its own modules, too.
class Module : public Given {
  public:
    /// Without a name its members have the owner's paths, and its knobs the owner's macros and block.
    Module(Module& owner, std::string name, std::string kind = "");
    ~Module() override;
    Module(const Module&) = delete;

    const std::string& kind() const override { return kind_; }
    const std::string& path() const { return path_; }  ///< "shadow", or "lights.shadow"; empty: the chapter itself

    Macros macros() const override;
    std::span<const std::byte> block(const Binding& binding) const override;
    void expand(std::vector<const Given*>& into) const override;

    /// Of it and of all its modules, in the order of declaration; of a chapter all there are.
    const KnobList& all_knobs() const;

    /// Epoch of the last change of one of its knobs, of a knob of its modules, of an exercise or of a shader.
    uint64_t epoch() const;

    /// At the start of a frame: gives targets their size, and turns histories over.
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size);

    /// Invalidates the history, after a change of scene or method.
    void forget_history();
    // [/module]

    // [life]
    // A module's life. A chapter asks all of its modules in order of declaration, each after the modules it owns;
    // nothing is forwarded by hand.

    /// A scene was loaded or reloaded: rebuild everything made from it.
    virtual void prepare(Gpu&, Scene&) {}

    /// Whether its picture changes with time, or gathers samples over frames.
    virtual bool animated() const { return false; }

    /// Dependencies of prepare() other than the scene, as text: a change reloads the scene.
    virtual std::string load_key() const { return {}; }

    /// Whether its picture is gathered over frames, and of how many.
    virtual Gathering gathering() const { return {}; }

    /// Exercises that run while a scene is loaded: toggling one of them loads it again.
    virtual std::vector<std::string> load_exercises() const { return {}; }

    /// Whether this module reads such a file itself; `into` then gets the model that stands for it in the scene, of no
    /// triangles where the module draws it, too.
    virtual bool stands_for(const std::filesystem::path& /*file*/, Model& /*into*/) const { return false; }

    /// Sound that a window plays with the picture, from 0 s on; null: none. Valid until the next prepare().
    virtual const Sound* sound() const { return nullptr; }

    /// Of the last frame, for the panel beside the times and for --timings: a line each; none before it had one.
    virtual std::vector<std::string> status() const { return {}; }

    /// False: not asked any of the above, nor are its modules. None given: always true.
    std::function<bool()> in_use;

    void prepare_all(Gpu& gpu, Scene& scene);
    bool any_animated() const;
    Gathering longest_gathering() const;  ///< of the module that takes the most frames
    bool any_model(const std::filesystem::path& file, Model& into) const;
    const Sound* any_sound() const;  ///< of the first module that has one
    std::vector<std::string> all_status() const;
    std::string load_state() const;  ///< all load keys, and the toggles of all load exercises
    bool loads_exercise() const;     ///< some exercise runs at load, in the student's version
                                     // [/life]

  protected:
    Module() = default;  ///< a chapter: it has no owner and no name

  private:
    /// Its knobs and those of its modules without a name.
    template <class Visit>
    void visit_own(const Visit& visit) const {
        for (const Member& member : members_)
            if (member.knob)
                visit(*member.knob);
            else if (member.module->kind_.empty())
                member.module->visit_own(visit);
    }
    /// A knob came or went.
    void forget_macros();
    friend class KnobBase;
    friend class TargetBase;
    template <class Self, class Visit>
    static void visit_used(Self& self, const Visit& visit);
    Module* owner_ = nullptr;
    std::string path_, kind_;
    struct Member {  ///< one of the two
        KnobBase* knob = nullptr;
        Module* module = nullptr;
    };
    std::vector<Member> members_;
    std::vector<TargetBase*> targets_;
    mutable std::optional<KnobList> all_;
    mutable Made knobs_seen_;
    mutable uint64_t epoch_ = 0;  ///< of its knobs
    mutable std::optional<Macros> macros_;
    mutable std::vector<std::pair<const KnobBase*, size_t>> compiled_;  ///< with variants; the ones in macros_
    /// Uniform blocks that shaders have of it, and their bytes the last time. A few.
    struct Block {
        uint64_t layout = 0;
        std::vector<const KnobBase*> knobs{};  ///< of each member
        std::vector<std::byte> bytes{};
    };
    mutable std::vector<Block> blocks_;
    uint64_t block_name_ = BindingName("knobs").hash;
};

}  // namespace lightwalk
