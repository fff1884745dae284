# One test writes pictures with stb to read them back.
target_link_libraries(test_common PRIVATE PkgConfig::stb)

# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_scene tests/common/corpus/scene
if(LIGHTWALK_FUZZ)
  foreach(name fuzz_scene fuzz_image fuzz_json fuzz_model)
    add_executable(${name} ${CMAKE_CURRENT_LIST_DIR}/fuzz/${name}.cpp)
    target_link_libraries(${name} PRIVATE lightwalk)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  endforeach()
endif()
