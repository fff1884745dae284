# Music: Ogg Vorbis files and their spectra.
find_library(VORBISFILE vorbisfile REQUIRED)
find_library(OGG ogg REQUIRED)
find_library(KISSFFT kissfft-float REQUIRED)
target_link_libraries(chapter_14_environment PUBLIC ${VORBISFILE} ${OGG} ${KISSFFT})

# Makes assets/tables/flakes.binary, by hand: see table/walk_paint.cpp.
if(EXISTS ${folder}/table/walk_paint.cpp)  # a handout has none
  lightwalk_program(walk_paint ${folder}/table/walk_paint.cpp chapter_${chapter})
  set_target_properties(walk_paint PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
