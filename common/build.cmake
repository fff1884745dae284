# How common and the chapters become targets. A new chapter is a new folder: nothing here names one, or a file of one.

# Several files in one compilation: to read their headers takes longer than to compile what they add.
set(together UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)

# Sets `sources` to the files of a list that are named as sources are: not an editor's lock, a backup, a copy.
function(lightwalk_plain)
  list(FILTER ARGN INCLUDE REGEX "/[A-Za-z0-9][A-Za-z0-9_]*\\.(cpp|h|o)$")
  set(plain)
  foreach(file ${ARGN})
    if(EXISTS ${file}) # no link to nothing
      list(APPEND plain ${file})
    endif()
  endforeach()
  set(sources ${plain} PARENT_SCOPE)
endfunction()

# A shared library of the files in rooms of common, but for those with a main.
function(lightwalk_library name)
  set(sources)
  foreach(room ${ARGN})
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/common/${room}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  lightwalk_plain(${sources})
  list(FILTER sources EXCLUDE REGEX "_main\\.cpp$")
  add_library(${name} SHARED ${sources})
  # Programs share its precompiled header, and therefore its flags and definitions.
  set_target_properties(${name} PROPERTIES DEFINE_SYMBOL "" ${together})
  # It calls its own functions directly, not through a table that other files could fill: recording a frame touches less
  # memory, and a program's start looks up fewer names.
  target_link_options(${name} PRIVATE LINKER:-Bsymbolic-functions)
endfunction()

# common: the library of all programs, and one of checks, which chapters' programs do without. Rooms use only those before
# them (common/course/test/order.py).
lightwalk_library(lightwalk base gpu image scene app measure study window)
# Each file loads all of it: what most do not need, JSON for one, costs them more than it saves the others.
target_precompile_headers(lightwalk PRIVATE <algorithm> <array> <filesystem> <functional> <map> <memory> <optional>
                          <span> <string> <string_view> <vector> <fmt/core.h> <glm/glm.hpp>
                          <glm/gtc/matrix_transform.hpp> <common/gpu/frame.h>)
target_include_directories(lightwalk PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/chapters)
target_include_directories(lightwalk SYSTEM PUBLIC ${PROJECT_SOURCE_DIR}/shaders)
target_compile_definitions(lightwalk PUBLIC GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_RADIANS GLM_ENABLE_EXPERIMENTAL)
target_link_libraries(lightwalk PUBLIC fmt::fmt glm::glm nlohmann_json::nlohmann_json Threads::Threads Vulkan::Vulkan)
target_link_libraries(lightwalk PRIVATE ZLIB::ZLIB glslang::glslang glslang::SPIRV glslang::glslang-default-resource-limits
                      SPIRV-Tools-static ${SPIRV_CROSS} CLI11::CLI11 PkgConfig::stb assimp::assimp glfw ${MESHOPTIMIZER}
                      ${DRACO} ${WEBP} PkgConfig::imgui)
lightwalk_library(lightwalk_check check judge)
target_precompile_headers(lightwalk_check REUSE_FROM lightwalk)
target_link_libraries(lightwalk_check PUBLIC lightwalk)

# A program of these sources, and what it is linked with.
function(lightwalk_program name sources)
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${ARGN})
  target_precompile_headers(${name} REUSE_FROM lightwalk)
endfunction()

file(GLOB solutions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/solution)
if(NOT solutions) # a handout
  target_compile_definitions(lightwalk INTERFACE LIGHTWALK_NO_SOLUTION)
endif()
if(EXISTS ${PROJECT_SOURCE_DIR}/compiled_for) # a handout with checks as objects
  file(STRINGS ${PROJECT_SOURCE_DIR}/compiled_for processor)
  if(NOT processor STREQUAL CMAKE_SYSTEM_PROCESSOR)
    message(FATAL_ERROR "The checks of this copy were compiled for ${processor}, this is ${CMAKE_SYSTEM_PROCESSOR}: "
                        "ask for one made with ./course handout --sources")
  endif()
endif()
file(GLOB mains CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/common/measure/*_main.cpp ${PROJECT_SOURCE_DIR}/common/window/*_main.cpp)
lightwalk_plain(${mains})
foreach(main ${sources})
  string(REGEX REPLACE ".*/(.*)_main\\.cpp" "\\1" name ${main})
  lightwalk_program(${name} ${main} lightwalk CLI11::CLI11 glfw PkgConfig::imgui)
endforeach()

# The students' C++: warnings are shown and are no errors, and a file that does not compile takes nothing else down. It
# becomes an empty object, whose function is then null (EXERCISE declares it weak), and what the compiler said lies beside
# it as FILE.o.error. Objects rather than a library: nothing asks the linker for a weak function.
function(lightwalk_exercises chapter reach)
  # The manifest; a new chapter's are not in it yet.
  file(STRINGS ${PROJECT_SOURCE_DIR}/tests/starters.txt listed REGEX " chapters/${chapter}/exercise/[a-z0-9_]+\\.cpp$")
  list(TRANSFORM listed REPLACE "^[0-9a-f]+ " "${PROJECT_SOURCE_DIR}/")
  if(NOT listed)
    file(GLOB listed CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/${chapter}/exercise/*.cpp)
  endif()
  lightwalk_plain(${listed})
  if(NOT sources)
    return()
  endif()
  add_library(exercises_${chapter} OBJECT ${sources})
  target_link_libraries(exercises_${chapter} PRIVATE lightwalk)
  target_compile_options(exercises_${chapter} PRIVATE -Wno-error)
  set_target_properties(exercises_${chapter} PROPERTIES CXX_COMPILER_LAUNCHER
    "sh;${PROJECT_SOURCE_DIR}/common/course/build/compile_exercise.sh;${CMAKE_CXX_COMPILER_LAUNCHER}")
  target_precompile_headers(exercises_${chapter} REUSE_FROM lightwalk)
  target_link_libraries(chapter_${chapter} ${reach} $<TARGET_OBJECTS:exercises_${chapter}>)
endfunction()

# A chapter's library: all its files but its main.cpp, and those of the chapters that it includes. Files of solutions, and
# those that include a truth, are objects of their own, which a handout has compiled or not at all, and a student's process
# does not have (common/course/grading).
function(lightwalk_chapter_library chapter)
  set(folder ${PROJECT_SOURCE_DIR}/chapters/${chapter})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.o ${folder}/solution/*.cpp)
  lightwalk_plain(${sources})
  list(REMOVE_ITEM sources ${folder}/main.cpp)
  if(sources)
    add_library(chapter_${chapter} STATIC ${sources})
    set_target_properties(chapter_${chapter} PROPERTIES LINKER_LANGUAGE CXX ${together})
    target_precompile_headers(chapter_${chapter} REUSE_FROM lightwalk)
    set(reach PUBLIC)
  else() # all it has is its main.cpp
    add_library(chapter_${chapter} INTERFACE)
    set(reach INTERFACE)
  endif()
  foreach(source ${sources})
    file(STRINGS ${source} truth LIMIT_COUNT 1 REGEX "^#include .*truth\\.h")
    if(truth OR source MATCHES "/solution/")
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  list(TRANSFORM ARGN PREPEND chapter_ OUTPUT_VARIABLE others)
  target_link_libraries(chapter_${chapter} ${reach} lightwalk ${others})
  lightwalk_exercises(${chapter} ${reach})
  include(${folder}/build.cmake OPTIONAL)
endfunction()

# A chapter is linked with common and the earlier chapters that it includes; which it may include is a test's
# (common/course/test/order.py). ./course configures again where a file includes a further one than chapters.links says.
file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/[0-9]*)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/starters.txt)
file(STRINGS ${PROJECT_SOURCE_DIR}/tests/starters.txt listed)
foreach(folder ${found}) # of several of one number those in the manifest: common/course/tree.py
  get_filename_component(chapter ${folder} NAME)
  string(SUBSTRING ${chapter} 0 3 number)
  if(NOT "${listed}" MATCHES "/${chapter}/" AND ("${listed}" MATCHES "/${number}" OR NOT chapter MATCHES "^[0-9][0-9]_[a-z0-9_]+$"))
    continue()
  endif()
  file(GLOB_RECURSE files ${folder}/*.cpp ${folder}/*.h)
  lightwalk_plain(${files})
  set(includes)
  foreach(file ${sources})
    file(STRINGS ${file} lines REGEX "^#include \"[0-9][0-9]_[a-z0-9_]+/")
    list(APPEND includes ${lines})
  endforeach()
  set(included)
  foreach(name ${earlier})
    if(includes MATCHES "\"${name}/")
      list(APPEND included ${name})
    endif()
  endforeach()
  list(JOIN included " " words)
  string(APPEND links "${chapter} ${words}\n")
  lightwalk_chapter_library(${chapter} ${included})
  lightwalk_program(${chapter} ${folder}/main.cpp chapter_${chapter})
  target_compile_definitions(${chapter} PRIVATE LIGHTWALK_CHAPTER="${chapter}")
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
file(WRITE ${PROJECT_BINARY_DIR}/chapters.links "${links}")
add_custom_target(every_shader DEPENDS ${every_shader})
add_custom_target(programs DEPENDS ${earlier} menu)  # what a person starts, without the tests
set(LIGHTWALK_CHAPTERS ${earlier})
