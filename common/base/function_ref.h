// Non-owning function reference, free of allocations.
#pragma once
#include <concepts>
#include <memory>
#include <type_traits>

namespace lightwalk {

template <class Signature>
class FunctionRef;

/// Reference to a callable, for parameters only: must not outlive the callable.
template <class... Arguments>
class FunctionRef<void(Arguments...)> {
  public:
    template <class Callable>
    requires(std::invocable<Callable&, Arguments...> && !std::same_as<std::remove_cvref_t<Callable>, FunctionRef>)
        FunctionRef(Callable&& callable)
        : callable_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
          call_([](void* known, Arguments... arguments) {
              (*static_cast<std::remove_reference_t<Callable>*>(known))(static_cast<Arguments>(arguments)...);
          }) {}
    void operator()(Arguments... arguments) const { call_(callable_, static_cast<Arguments>(arguments)...); }

  private:
    void* callable_;
    void (*call_)(void*, Arguments...);
};

}  // namespace lightwalk
