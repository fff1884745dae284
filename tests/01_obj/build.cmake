# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_obj tests/01_obj/corpus/obj
if(LIGHTWALK_FUZZ)
  foreach(name fuzz_obj fuzz_mtl)
    add_executable(${name} ${CMAKE_CURRENT_LIST_DIR}/fuzz/${name}.cpp ${CMAKE_CURRENT_LIST_DIR}/agreement.cpp)
    target_link_libraries(${name} PRIVATE chapter_01_obj $<TARGET_OBJECTS:chapter_01_obj>)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  endforeach()
endif()
