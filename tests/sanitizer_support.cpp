// For sanitizer builds: foreign allocations are not leaks.

// Nothing is unloaded, so a Vulkan driver's process-wide memory is still reachable at the end.
extern "C" int dlclose(void*) { return 0; }

// lavapipe and its compiler leak a little of some shaders; validation reports our own leaks.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\nleak:libLLVM\n";
}
