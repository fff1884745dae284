# Makes assets/tables/ggx.pfm, by hand: see table/fit_ggx.cpp.
if(EXISTS ${folder}/table/fit_ggx.cpp)  # a handout has none
  lightwalk_program(fit_ggx ${folder}/table/fit_ggx.cpp chapter_${chapter})
  set_target_properties(fit_ggx PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
