# Tests write PNG files of their own.
target_link_libraries(test_15_terrain_water PRIVATE ZLIB::ZLIB)

# The chapter of docs/framework.md (test_framework.py).
set(sources ${CMAKE_CURRENT_LIST_DIR}/compositions/glass_valley.cpp ${CMAKE_CURRENT_LIST_DIR}/compositions/parts.cpp)
lightwalk_program(glass_valley "${sources}" chapter_15_terrain_water)
target_compile_definitions(glass_valley PRIVATE LIGHTWALK_CHAPTER="99_glass_valley")
lightwalk_compiled_fast(glass_valley)
