# Tests write PNG files of their own.
target_link_libraries(test_15_terrain_water PRIVATE ZLIB::ZLIB)
