# Tests write Ogg Vorbis files of their own.
find_library(VORBISENC vorbisenc REQUIRED)
find_library(VORBIS vorbis REQUIRED)
target_link_libraries(test_14_environment PRIVATE ${VORBISENC} ${VORBIS})

# Throw-away chapters behind this one: the contract of drawings is tried with them (test_compositions.py).
foreach(name everything everything_deferred)
  lightwalk_program(${name} ${CMAKE_CURRENT_LIST_DIR}/compositions/everything.cpp chapter_14_environment chapter_13_mlaa)
  target_compile_definitions(${name} PRIVATE LIGHTWALK_CHAPTER="99_${name}")
  lightwalk_compiled_fast(${name})
endforeach()
target_compile_definitions(everything_deferred PRIVATE LIGHTWALK_THROUGH_GBUFFER)

# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_measured tests/14_environment/corpus/measured
if(LIGHTWALK_FUZZ)
  add_executable(fuzz_measured ${CMAKE_CURRENT_LIST_DIR}/fuzz/fuzz_measured.cpp)
  target_link_libraries(fuzz_measured PRIVATE chapter_14_environment)
  target_link_options(fuzz_measured PRIVATE -fsanitize=fuzzer)
endif()
