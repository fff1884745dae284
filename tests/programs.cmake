# The programs of the tests.

include(${CMAKE_CURRENT_LIST_DIR}/needs.cmake)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)

# Tests run about as often as they are compiled: -O1 takes a quarter off a file, and hardly shows in what it does.
# GCC 13 and later set two flags of x86's at -O2 that a precompiled header must share with what includes it.
function(lightwalk_compiled_fast name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13
     AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64|i.86)$")
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-munroll-only-small-loops;-mvzeroupper>")
  endif()
endfunction()

# The mains of Catch2's programs, of checks, and of the process that has a student's C++.
function(lightwalk_mains)
  if(Catch2_VERSION VERSION_LESS 3) # all of it is in this file: one copy for all programs
    add_library(catch_main SHARED ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
    target_link_libraries(catch_main PUBLIC Catch2::Catch2)
  else()
    add_library(catch_main OBJECT ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
    target_link_libraries(catch_main PUBLIC Catch2::Catch2WithMain)
  endif()
  target_compile_options(catch_main PRIVATE -O0 -g0)
  target_include_directories(catch_main PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  add_library(check_main OBJECT ${PROJECT_SOURCE_DIR}/common/check/check_main.cpp)
  add_library(serve_main OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/common/judge/serve_main.cpp)
  foreach(name check_main serve_main)
    target_link_libraries(${name} PUBLIC lightwalk_check)
    lightwalk_compiled_fast(${name})
    target_precompile_headers(${name} REUSE_FROM lightwalk)
  endforeach()
  if(LIGHTWALK_SANITIZE)
    add_library(sanitizer_support SHARED ${PROJECT_SOURCE_DIR}/tests/sanitizer_support.cpp)
    target_link_libraries(lightwalk PUBLIC sanitizer_support)
  endif()
endfunction()

# What ./course grade needs, built when it asks. judge_NN is check_NN whose C++ exercises ask another process; serve_NN is
# what that process is linked from, with the student's object: it has neither the checks nor the references, but the trials
# (common/check/trial.h), compiled without references too.
function(lightwalk_judge name folder library)
  foreach(side remote serve)
    set(text "#include \"common/judge/${side}.h\"\n")
    if(EXISTS ${PROJECT_SOURCE_DIR}/chapters/${name}/exercises.h)
      string(APPEND text "\n#include \"${name}/exercises.h\"\n")
      if(EXISTS ${folder}/trials.h)
        string(APPEND text "#include \"tests/${name}/trials.h\"\n")
      endif()
    endif()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/grade/${side}_${name}.cpp CONTENT "${text}" @ONLY)
  endforeach()
  add_executable(judge_${name} EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/grade/remote_${name}.cpp
                 $<TARGET_OBJECTS:checks_${name}>)
  target_link_libraries(judge_${name} PRIVATE check_main ${library})
  add_library(serve_${name} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/grade/serve_${name}.cpp ${ARGN})
  target_link_libraries(serve_${name} PRIVATE lightwalk_check ${library})
  target_compile_definitions(serve_${name} PRIVATE LIGHTWALK_NO_SOLUTION)
  target_precompile_headers(judge_${name} REUSE_FROM lightwalk)
  target_precompile_headers(serve_${name} REUSE_FROM lightwalk)
  set_target_properties(judge_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/grade)
endfunction()

# The checks_*.cpp of a chapter: the program that ./course check runs, with the chapter's library, and the judge. Trials are
# where the student's C++ is: not in the judge.
function(lightwalk_checks name folder library)
  file(GLOB checks CONFIGURE_DEPENDS ${folder}/checks_*.cpp)
  file(GLOB objects CONFIGURE_DEPENDS ${folder}/checks_*.o) # of a handout
  if(checks)
    set(trials ${checks})
    list(FILTER trials INCLUDE REGEX "/checks_trial_")
    list(FILTER checks EXCLUDE REGEX "/checks_trial_")
    foreach(part checks trials)
      if(${part})
        add_library(${part}_${name} OBJECT ${${part}})
        target_link_libraries(${part}_${name} PUBLIC lightwalk_check ${library})
        lightwalk_compiled_fast(${part}_${name})
        set_target_properties(${part}_${name} PROPERTIES ${together})
        target_precompile_headers(${part}_${name} REUSE_FROM lightwalk)
        list(APPEND objects $<TARGET_OBJECTS:${part}_${name}>)
      endif()
    endforeach()
    lightwalk_judge(${name} ${folder} ${library} ${trials})
  endif()
  if(objects)
    add_executable(check_${name} ${objects})
    set_target_properties(check_${name} PROPERTIES LINKER_LANGUAGE CXX)
    target_link_libraries(check_${name} PRIVATE check_main ${library})
    set(checks_of_${name} ${objects} PARENT_SCOPE)
  endif()
endfunction()

# All answers to a chapter's C++ exercises in one program, on which its checks must reach the stated verdicts.
function(lightwalk_variants name folder library)
  file(GLOB answers CONFIGURE_DEPENDS ${folder}/variants/*)
  file(GLOB solutions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/${name}/solution/*.cpp)
  if(LIGHTWALK_SANITIZE OR NOT answers OR NOT solutions) # sanitizers have their own words for what is wrong
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/variants/${name}.cpp)
  add_custom_command(OUTPUT ${source} COMMAND ${PYTHON3} common/course check.variants ${name} ${source}
                     DEPENDS ${answers} ${solutions} ${PROJECT_SOURCE_DIR}/chapters/${name}/exercises.h
                             ${PROJECT_SOURCE_DIR}/common/course/check/variants.py
                     WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  lightwalk_program(variants_${name} "${source};${ARGN}" check_main ${library})
  set_target_properties(variants_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  lightwalk_compiled_fast(variants_${name})
  target_compile_options(variants_${name} PRIVATE -w -g0)
endfunction()

# tests/common and tests/NN_name: one Catch2 program each, with the chapter's checks.
function(lightwalk_catch_program name folder library)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/checks_")
  if(NOT sources)
    return()
  endif()
  lightwalk_program(test_${name} "${sources};${ARGN}" catch_main lightwalk_check ${library})
  lightwalk_compiled_fast(test_${name})
  set_target_properties(test_${name} PROPERTIES ${together})
  # Those of stability are a test of their own, which also keeps their figures.
  list(FILTER sources EXCLUDE REGEX "/test_stability\\.cpp$")
  if(sources)
    add_test(NAME unit.${name} COMMAND test_${name} -\# "~[#test_stability]~[.]" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  endif()
endfunction()

lightwalk_mains()
foreach(name common ${LIGHTWALK_CHAPTERS})
  set(folder ${PROJECT_SOURCE_DIR}/tests/${name})
  set(library lightwalk)
  if(TARGET chapter_${name})
    set(library chapter_${name})
  endif()
  lightwalk_checks(${name} ${folder} ${library})
  lightwalk_variants(${name} ${folder} ${library} ${checks_of_${name}})
  lightwalk_catch_program(${name} ${folder} ${library} ${checks_of_${name}})
  if(EXISTS ${folder}/build.cmake)
    include(${folder}/build.cmake)
  endif()
endforeach()
