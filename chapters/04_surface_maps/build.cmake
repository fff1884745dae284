# Makes assets/tables/ggx.pfm, by hand: see table/fit_ggx.cpp.
if(EXISTS ${folder}/table/fit_ggx.cpp)  # a handout has none
  add_executable(fit_ggx EXCLUDE_FROM_ALL ${folder}/table/fit_ggx.cpp)
  target_link_libraries(fit_ggx PRIVATE chapter_${chapter})
  target_precompile_headers(fit_ggx REUSE_FROM lightwalk)
  set_target_properties(fit_ggx PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endif()
