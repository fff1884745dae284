# Tests write PNG files of their own.
target_link_libraries(test_15_terrain_water PRIVATE ZLIB::ZLIB)

# The chapter of docs/framework.md (test_framework.py).
add_executable(glass_valley ${CMAKE_CURRENT_LIST_DIR}/compositions/glass_valley.cpp
                            ${CMAKE_CURRENT_LIST_DIR}/compositions/parts.cpp)
target_link_libraries(glass_valley PRIVATE chapter_15_terrain_water)
target_compile_definitions(glass_valley PRIVATE LIGHTWALK_CHAPTER="99_glass_valley")
lightwalk_compiled_fast(glass_valley)
target_precompile_headers(glass_valley REUSE_FROM lightwalk)
set_target_properties(glass_valley PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
