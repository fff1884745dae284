# Makes assets/planets_2k/jupiter_1.jpg to jupiter_4.jpg, by hand: see sequence/carry_clouds.cpp.
add_executable(carry_clouds EXCLUDE_FROM_ALL ${folder}/sequence/carry_clouds.cpp)
target_link_libraries(carry_clouds PRIVATE chapter_${chapter} PkgConfig::stb)
target_precompile_headers(carry_clouds REUSE_FROM lightwalk)
set_target_properties(carry_clouds PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
