# Rays written by others, to compare with: Debian's libembree-dev. Without it that test says that it is left out.
find_path(EMBREE_INCLUDE NAMES embree3/rtcore.h embree4/rtcore.h)
find_library(EMBREE NAMES embree3 embree4)
if(EMBREE AND EMBREE_INCLUDE)
  target_link_libraries(test_05_shadow_maps PRIVATE ${EMBREE})
  target_include_directories(test_05_shadow_maps SYSTEM PRIVATE ${EMBREE_INCLUDE})
  target_compile_definitions(test_05_shadow_maps PRIVATE LIGHTWALK_EMBREE)
endif()
