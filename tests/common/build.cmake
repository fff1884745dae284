# One test writes pictures with stb to read them back.
target_link_libraries(test_common PRIVATE PkgConfig::stb)

# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_scene tests/common/corpus/scene
if(LIGHTWALK_FUZZ)
  add_executable(fuzz_scene ${CMAKE_CURRENT_LIST_DIR}/fuzz/fuzz_scene.cpp)
  target_link_libraries(fuzz_scene PRIVATE lightwalk)
  target_link_options(fuzz_scene PRIVATE -fsanitize=fuzzer)
endif()
