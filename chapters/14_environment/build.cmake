# Music: Ogg Vorbis files and their spectra.
find_library(VORBISFILE vorbisfile REQUIRED)
find_library(OGG ogg REQUIRED)
find_library(KISSFFT kissfft-float REQUIRED)
target_link_libraries(chapter_14_environment PUBLIC ${VORBISFILE} ${OGG} ${KISSFFT})

# Makes assets/tables/flakes.binary, by hand: see table/walk_paint.cpp.
if(EXISTS ${folder}/table/walk_paint.cpp)  # a handout has none
  add_executable(walk_paint EXCLUDE_FROM_ALL ${folder}/table/walk_paint.cpp)
  target_link_libraries(walk_paint PRIVATE chapter_${chapter})
  target_precompile_headers(walk_paint REUSE_FROM lightwalk)
  set_target_properties(walk_paint PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endif()
