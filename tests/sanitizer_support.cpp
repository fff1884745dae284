// For sanitizer builds: what is not this course's to free is no leak.

// Nothing is unloaded, so what a Vulkan driver keeps for the whole process is still reachable at the end.
extern "C" int dlclose(void*) { return 0; }

// lavapipe and its compiler leak a little of some shaders; what we forget to destroy, validation tells.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\nleak:libLLVM\n";
}
