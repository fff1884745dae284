# Music: Ogg Vorbis files and their spectra.
find_library(VORBISFILE vorbisfile REQUIRED)
find_library(OGG ogg REQUIRED)
find_library(KISSFFT kissfft-float REQUIRED)
target_link_libraries(chapter_14_environment PUBLIC ${VORBISFILE} ${OGG} ${KISSFFT})
