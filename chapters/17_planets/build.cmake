# Makes assets/planets_2k/jupiter_1.jpg to jupiter_4.jpg, by hand: see sequence/carry_clouds.cpp.
lightwalk_program(carry_clouds ${folder}/sequence/carry_clouds.cpp chapter_${chapter} PkgConfig::stb)
set_target_properties(carry_clouds PROPERTIES EXCLUDE_FROM_ALL ON)
