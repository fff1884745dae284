# Tests write Ogg Vorbis files of their own.
find_library(VORBISENC vorbisenc REQUIRED)
find_library(VORBIS vorbis REQUIRED)
target_link_libraries(test_14_environment PRIVATE ${VORBISENC} ${VORBIS})
