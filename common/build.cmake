# How the tree becomes targets. A new chapter is a new folder; nothing here names one.

# common: three shared libraries, so that a chapter's program holds the chapter alone and compiles no checks, and a program
# of checks loads no more than runs a shader. Rooms use only those before them (common/course/test/order.py).
function(lightwalk_common)
  lightwalk_library(lightwalk "base;gpu" "")
  lightwalk_library(lightwalk_check "check;judge" run_checks)
  lightwalk_library(lightwalk_app "image;scene;app;measure;study;window" "options;lists;json_lines;scene_write")
  # Each file loads all of it: what most do not need, JSON for one, costs them more than it saves the others.
  target_precompile_headers(lightwalk PRIVATE <algorithm> <array> <filesystem> <functional> <map> <memory> <optional>
                            <span> <string> <string_view> <vector> <fmt/core.h> <glm/glm.hpp>
                            <glm/gtc/matrix_transform.hpp>)
  foreach(name lightwalk_check lightwalk_app)
    lightwalk_precompiled(${name})
    target_link_libraries(${name} PUBLIC lightwalk)
  endforeach()
  target_include_directories(lightwalk PUBLIC ${PROJECT_SOURCE_DIR})
  target_include_directories(lightwalk SYSTEM PUBLIC ${PROJECT_SOURCE_DIR}/shaders)
  target_compile_definitions(lightwalk PUBLIC GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_RADIANS GLM_ENABLE_EXPERIMENTAL)
  target_link_libraries(lightwalk PUBLIC fmt::fmt glm::glm nlohmann_json::nlohmann_json Threads::Threads
                        Vulkan::Vulkan)
  target_link_libraries(lightwalk PRIVATE ZLIB::ZLIB glslang::glslang glslang::SPIRV
                        glslang::glslang-default-resource-limits SPIRV-Tools-static ${SPIRV_CROSS} CLI11::CLI11)
  target_link_libraries(lightwalk_app PRIVATE PkgConfig::stb ZLIB::ZLIB assimp::assimp glfw ${MESHOPTIMIZER} ${DRACO} ${WEBP}
                        PkgConfig::imgui CLI11::CLI11)
  file(GLOB solutions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/solution)
  if(NOT solutions) # a handout
    target_compile_definitions(lightwalk PUBLIC LIGHTWALK_NO_SOLUTION)
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/compiled_for) # a handout with checks as objects
    file(STRINGS ${PROJECT_SOURCE_DIR}/compiled_for processor)
    if(NOT processor STREQUAL CMAKE_SYSTEM_PROCESSOR)
      message(FATAL_ERROR "The checks of this copy were compiled for ${processor}, this is ${CMAKE_SYSTEM_PROCESSOR}: "
                          "ask for one made with ./course handout --sources")
    endif()
  endif()
  if(LIGHTWALK_SANITIZE)
    add_library(sanitizer_support SHARED ${PROJECT_SOURCE_DIR}/tests/sanitizer_support.cpp)
    target_link_libraries(lightwalk PUBLIC sanitizer_support)
  endif()
  set_source_files_properties(common/measure/compare_main.cpp PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON)
  if(LIGHTWALK_SANITIZE OR LIGHTWALK_FUZZ)
    # Debian builds glslang without type information, which this check of the undefined-behaviour sanitizer needs.
    set_source_files_properties(${PROJECT_SOURCE_DIR}/common/gpu/compile.cpp PROPERTIES
                                COMPILE_OPTIONS -fno-sanitize=vptr SKIP_PRECOMPILE_HEADERS ON)
  endif()
  foreach(program measure/compare window/menu)
    get_filename_component(name ${program} NAME)
    add_executable(${name} ${PROJECT_SOURCE_DIR}/common/${program}_main.cpp)
    lightwalk_precompiled(${name})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  endforeach()
  target_link_libraries(compare PRIVATE lightwalk_app CLI11::CLI11)
  target_link_libraries(menu PRIVATE lightwalk_app glfw PkgConfig::imgui)
endfunction()

# A shared library of the files in rooms of common. Reading a command line or JSON happens once in a run: that files named
# `plain`, for which the headers of CLI11 and JSON are the cost, compile fast matters more. They are not optimised.
function(lightwalk_library name rooms plain)
  set(sources)
  foreach(room ${rooms})
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/common/${room}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  list(FILTER sources EXCLUDE REGEX "_main\\.cpp$")
  list(JOIN plain "|" plain)
  set(plain_sources ${sources})
  list(FILTER plain_sources INCLUDE REGEX "/(${plain})\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "/(${plain})\\.cpp$")
  add_library(${name} SHARED ${sources})
  set_target_properties(${name} PROPERTIES DEFINE_SYMBOL "") # programs share its precompiled header
  lightwalk_compiled_together(${name})
  if(NOT plain_sources)
    return()
  endif()
  add_library(${name}_plain OBJECT ${plain_sources})
  target_include_directories(${name}_plain PRIVATE $<TARGET_PROPERTY:lightwalk,INTERFACE_INCLUDE_DIRECTORIES>)
  target_include_directories(${name}_plain SYSTEM PRIVATE
                             $<TARGET_PROPERTY:lightwalk,INTERFACE_SYSTEM_INCLUDE_DIRECTORIES>)
  target_compile_definitions(${name}_plain PRIVATE $<TARGET_PROPERTY:lightwalk,INTERFACE_COMPILE_DEFINITIONS>)
  target_link_libraries(${name}_plain PRIVATE fmt::fmt glm::glm nlohmann_json::nlohmann_json Vulkan::Vulkan CLI11::CLI11)
  target_compile_options(${name}_plain PRIVATE -O0)
  set_target_properties(${name}_plain PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 2)
  set_source_files_properties(common/scene/scene_write.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # its json keeps the order of keys
  # A scene of 100,000 objects is 14 MB of JSON.
  set_source_files_properties(common/scene/json_lines.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS -O2)
  target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}_plain>)
endfunction()

# One precompiled header for all, which they can share because they share flags and definitions.
function(lightwalk_precompiled name)
  target_precompile_headers(${name} REUSE_FROM lightwalk)
endfunction()

# Several files at a time: their headers are read once. Not for chapters, of whose objects a handout and grade need some.
function(lightwalk_compiled_together name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
endfunction()

# Tests run once for each time they are compiled: -O1 takes a third off a file, and hardly shows in what it does.
# GCC 13 and later set two flags of x86's at -O2 that a precompiled header must share with what includes it.
function(lightwalk_compiled_fast name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13
     AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64|i.86)$")
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-munroll-only-small-loops;-mvzeroupper>")
  endif()
endfunction()

# The students' C++: warnings are shown and are no errors, and a file that does not compile takes nothing else down. It
# becomes an empty object, whose function is then null (EXERCISE declares it weak), and what the compiler said lies beside
# it as FILE.o.error. Objects rather than a library: nothing asks the linker for a weak function.
function(lightwalk_exercises chapter visible)
  add_library(exercises_${chapter} OBJECT ${ARGN})
  target_include_directories(exercises_${chapter} PRIVATE ${visible})
  target_link_libraries(exercises_${chapter} PRIVATE lightwalk)
  target_compile_options(exercises_${chapter} PRIVATE -Wno-error)
  set_target_properties(exercises_${chapter} PROPERTIES CXX_COMPILER_LAUNCHER
    "sh;${PROJECT_SOURCE_DIR}/common/course/build/compile_exercise.sh;${CMAKE_CXX_COMPILER_LAUNCHER}")
  lightwalk_precompiled(exercises_${chapter})
  target_link_libraries(chapter_${chapter} PUBLIC $<TARGET_OBJECTS:exercises_${chapter}>)
endfunction()

# A chapter sees common and earlier chapters: its include path holds links to those folders and to no other,
# so that including a later chapter does not compile.
function(lightwalk_chapters)
  file(GLOB folders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/[0-9]*)
  set(earlier)
  foreach(folder ${folders})
    get_filename_component(chapter ${folder} NAME)
    set(visible ${PROJECT_BINARY_DIR}/visible/${chapter})
    file(MAKE_DIRECTORY ${visible})
    foreach(name ${earlier} ${chapter})
      file(CREATE_LINK ${PROJECT_SOURCE_DIR}/chapters/${name} ${visible}/${name} SYMBOLIC)
    endforeach()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.o ${folder}/solution/*.cpp)
    file(GLOB exercises CONFIGURE_DEPENDS ${folder}/exercise/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    # What checks call: the references, and what these and the starters call; and modules, which have knobs, that the checks
    # of 06 and 07 draw with. Objects, for the checks and for the chapter.
    set(called "/solution/|/(read_floats|sums|spectrum)\\.cpp$")
    set(lent "/(lights|light_buffer|light_grid|object_lights|coverage|mip_chain|texels)\\.cpp$")
    foreach(part called lent)
      set(parts ${sources})
      list(FILTER parts INCLUDE REGEX ${${part}})
      if(parts)
        list(REMOVE_ITEM sources ${parts})
        add_library(${part}_${chapter} OBJECT ${parts})
        target_include_directories(${part}_${chapter} PRIVATE ${visible})
        target_link_libraries(${part}_${chapter} PRIVATE lightwalk)
        lightwalk_precompiled(${part}_${chapter})
        list(APPEND sources $<TARGET_OBJECTS:${part}_${chapter}>)
      endif()
    endforeach()
    if(sources)
      add_library(chapter_${chapter} STATIC ${sources})
      set(reach PUBLIC)
      set_target_properties(chapter_${chapter} PROPERTIES LINKER_LANGUAGE CXX)
      lightwalk_precompiled(chapter_${chapter})
    else() # all it has is its main.cpp
      add_library(chapter_${chapter} INTERFACE)
      set(reach INTERFACE)
    endif()
    target_include_directories(chapter_${chapter} ${reach} ${visible})
    target_link_libraries(chapter_${chapter} ${reach} lightwalk_app)
    foreach(name ${earlier})
      target_link_libraries(chapter_${chapter} ${reach} chapter_${name})
    endforeach()
    if(exercises)
      lightwalk_exercises(${chapter} ${visible} ${exercises})
    endif()
    if(EXISTS ${folder}/build.cmake)
      include(${folder}/build.cmake)
    endif()
    add_executable(${chapter} ${folder}/main.cpp)
    target_link_libraries(${chapter} PRIVATE chapter_${chapter})
    target_compile_definitions(${chapter} PRIVATE LIGHTWALK_CHAPTER="${chapter}")
    lightwalk_precompiled(${chapter})
    set_target_properties(${chapter} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/chapters)
    # Every shader is compiled and validated as part of the build, which also fills the cache. The
    # program says in chapter.shaders.d which files it read: only an edit of those compiles them again.
    set(stamp ${PROJECT_BINARY_DIR}/chapters/${chapter}.shaders)
    # With the default knobs; every variant is compiled by every_shader, for ./course test --all.
    add_custom_command(OUTPUT ${stamp} COMMAND ${chapter} --compile-shaders ${stamp} --default-variants DEPENDS ${chapter}
                       DEPFILE ${stamp}.d VERBATIM)
    add_custom_command(OUTPUT ${stamp}.all COMMAND ${chapter} --compile-shaders ${stamp}.all DEPENDS ${chapter}
                       DEPFILE ${stamp}.all.d VERBATIM)
    add_custom_target(shaders_${chapter} ALL DEPENDS ${stamp})
    list(APPEND every_shader ${stamp}.all)
    list(APPEND earlier ${chapter})
  endforeach()
  add_custom_target(every_shader DEPENDS ${every_shader})
  add_custom_target(programs DEPENDS ${earlier} menu)  # what a person starts, without the tests
  set(LIGHTWALK_CHAPTERS ${earlier} PARENT_SCOPE)
endfunction()

# The parts of a chapter's checks that run where the student's C++ does (common/check/trial.h).
function(lightwalk_add_trials target name)
  if(TARGET trials_${name})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:trials_${name}>)
  endif()
endfunction()

# A program of checks. Of its chapter it has the starters and what checks call: nothing else of the chapter, and none that
# it builds on, is compiled for it. The checks of 06 draw with chapter 03's lights, those of 15 and 18 have chapter 01's camera.
function(lightwalk_checked target name)
  target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:chapter_${name},INTERFACE_INCLUDE_DIRECTORIES>)
  set(parts exercises_${name} called_${name})
  if(name MATCHES "^(06|07|11|14)_") # which have a module
    list(APPEND parts lightwalk_app)
  endif()
  if(name MATCHES "^06_")
    list(APPEND parts lent_03_attenuation exercises_03_attenuation called_03_attenuation)
  elseif(name MATCHES "^07_")
    file(GLOB compiled CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/${name}/texels.o) # of a handout
    target_sources(${target} PRIVATE ${compiled})
    list(APPEND parts lent_${name})
  elseif(name MATCHES "^(15|18)_")
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/common/scene/view.cpp)
    list(APPEND parts exercises_01_obj called_01_obj)
  endif()
  target_link_libraries(${target} PRIVATE lightwalk_check)
  foreach(part ${parts})
    if(TARGET ${part})
      target_link_libraries(${target} PRIVATE ${part})
    endif()
  endforeach()
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
  target_link_libraries(serve_${name} PRIVATE ${library})
  target_compile_definitions(serve_${name} PRIVATE LIGHTWALK_NO_SOLUTION)
  foreach(target judge_${name} serve_${name})
    lightwalk_precompiled(${target})
  endforeach()
  set_target_properties(judge_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/grade)
endfunction()

# Variants of C++ exercises (common/course/check/variants.py), a check program each. Those listed as changes are written here as
# files, again when their list or the solution changes. All but the variant is one shared library of the chapter, which
# calls the variant: what a program defines goes before what its libraries do. Both are weak.
function(lightwalk_variants name folder library)
  file(GLOB variants CONFIGURE_DEPENDS ${folder}/variants/*.cpp)
  file(GLOB lists CONFIGURE_DEPENDS ${folder}/variants/*.changes)
  set(sources)
  foreach(list ${lists})
    get_filename_component(exercise ${list} NAME_WE)
    set(solution ${PROJECT_SOURCE_DIR}/chapters/${name}/solution/${exercise}.cpp)
    if(EXISTS ${solution}) # not in a handout
      list(APPEND sources ${list} ${solution})
    endif()
  endforeach()
  if(sources)
    set(script ${PROJECT_SOURCE_DIR}/common/course/check/variants.py)
    set(made ${PROJECT_BINARY_DIR}/variants/${name})
    execute_process(COMMAND python3 ${PROJECT_SOURCE_DIR}/common/course check.variants ${name} ${made} COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB changed ${made}/*.cpp)
    list(APPEND variants ${changed})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script} ${sources})
  endif()
  string(SUBSTRING ${name} 0 2 number)
  if(variants)
    add_library(checked_${name} SHARED EXCLUDE_FROM_ALL $<TARGET_OBJECTS:checks_${name}>)
    lightwalk_add_trials(checked_${name} ${name})
    set_target_properties(checked_${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/variants)
    target_link_options(checked_${name} PRIVATE -s) # nobody debugs them, and names are half of their size
    lightwalk_checked(checked_${name} ${name})
  endif()
  foreach(variant ${variants})
    get_filename_component(answer ${variant} NAME_WLE)
    set(target variant.${number}.${answer})
    add_executable(${target} EXCLUDE_FROM_ALL ${variant}) # variants.NN needs them
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${number}.${answer} ENABLE_EXPORTS ON
                          RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/variants)
    lightwalk_precompiled(${target})
    target_compile_options(${target} PRIVATE -Wno-error -w)
    target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
    target_link_options(${target} PRIVATE -s -Wl,--no-as-needed) # the library registers its checks when it is loaded
    target_link_libraries(${target} PRIVATE check_main checked_${name})
    set_property(GLOBAL APPEND PROPERTY LIGHTWALK_VARIANTS_${number} ${target})
  endforeach()
endfunction()

# tests/common and tests/NN_name: one Catch2 program each, and from the chapter's checks_*.cpp the program that
# ./course check runs.
function(lightwalk_tests)
  if(Catch2_VERSION VERSION_LESS 3) # all of it is in this file: one copy for all programs
    add_library(catch_main SHARED ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
  else()
    add_library(catch_main OBJECT ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
  endif()
  target_compile_options(catch_main PRIVATE -O0 -g0)
  target_link_libraries(catch_main INTERFACE $<LINK_ONLY:lightwalk_check>) # tests run shaders as checks do
  add_library(serve_main OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/common/judge/serve_main.cpp)
  target_compile_options(serve_main PRIVATE -O0)
  target_link_libraries(serve_main PRIVATE lightwalk_check)
  add_library(check_main OBJECT ${PROJECT_SOURCE_DIR}/common/check/check_main.cpp)
  target_link_libraries(check_main PUBLIC lightwalk_check)
  if(Catch2_VERSION VERSION_LESS 3)
    target_link_libraries(catch_main PUBLIC Catch2::Catch2)
  else()
    target_link_libraries(catch_main PUBLIC Catch2::Catch2WithMain)
  endif()
  target_include_directories(catch_main PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  # A test names its file: not the checkout's folder, or ccache would know it in no other one.
  target_compile_options(catch_main PUBLIC -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  foreach(name common ${LIGHTWALK_CHAPTERS})
    set(folder ${PROJECT_SOURCE_DIR}/tests/${name})
    set(library chapter_${name})
    if(name STREQUAL common)
      set(library lightwalk_app)
    endif()
    file(GLOB checks CONFIGURE_DEPENDS ${folder}/checks_*.cpp)
    file(GLOB compiled CONFIGURE_DEPENDS ${folder}/checks_*.o) # of a handout
    if(compiled)
      add_executable(check_${name} ${compiled})
      set_target_properties(check_${name} PROPERTIES LINKER_LANGUAGE CXX)
      target_link_libraries(check_${name} PRIVATE check_main)
      lightwalk_checked(check_${name} ${name})
    elseif(checks)
      set(trials ${checks})
      list(FILTER trials INCLUDE REGEX "/checks_trial_")
      list(FILTER checks EXCLUDE REGEX "/checks_trial_")
      add_library(checks_${name} OBJECT ${checks})
      lightwalk_precompiled(checks_${name})
      lightwalk_compiled_fast(checks_${name})
      target_link_libraries(checks_${name} PUBLIC check_main ${library})
      if(trials)
        add_library(trials_${name} OBJECT ${trials})
        lightwalk_precompiled(trials_${name})
        target_link_libraries(trials_${name} PUBLIC ${library})
      endif()
      lightwalk_judge(${name} ${folder} ${library} ${trials})
      add_executable(check_${name} $<TARGET_OBJECTS:checks_${name}>)
      lightwalk_add_trials(check_${name} ${name})
      target_link_libraries(check_${name} PRIVATE check_main)
      lightwalk_checked(check_${name} ${name})
    endif()
    if(NOT LIGHTWALK_SANITIZE) # which have their own words for what is wrong
      lightwalk_variants(${name} ${folder} ${library})
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/checks_")
    if(sources)
      add_executable(test_${name} ${sources})
      lightwalk_precompiled(test_${name})
      lightwalk_compiled_fast(test_${name})
      lightwalk_compiled_together(test_${name})
      if(TARGET checks_${name})
        target_sources(test_${name} PRIVATE $<TARGET_OBJECTS:checks_${name}>)
        lightwalk_add_trials(test_${name} ${name})
      endif()
      target_link_libraries(test_${name} PRIVATE catch_main ${library})
      # Those of stability are a test of their own (tests/build.cmake), which also keeps their figures.
      set(others ${sources})
      list(FILTER others EXCLUDE REGEX "/test_stability\\.cpp$")
      if(others)
        add_test(NAME unit.${name} COMMAND test_${name} -\# "~[#test_stability]~[.]" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
      endif()
    endif()
    if(EXISTS ${folder}/build.cmake)
      include(${folder}/build.cmake)
    endif()
  endforeach()
endfunction()
