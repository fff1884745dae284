# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_scene tests/common/corpus/scene
if(LIGHTWALK_FUZZ)
  add_executable(fuzz_scene ${CMAKE_CURRENT_LIST_DIR}/fuzz/fuzz_scene.cpp)
  target_link_libraries(fuzz_scene PRIVATE lightwalk_scene)
  target_link_options(fuzz_scene PRIVATE -fsanitize=fuzzer)
endif()
