# How the tree becomes targets. A new chapter is a new folder; nothing here names one.

# common: one library per folder, each using only those before it.
function(lightwalk_library name)
  cmake_parse_arguments(arg "" "FOLDER" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${arg_FOLDER}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_main\\.cpp$")
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${arg_LINK})
  lightwalk_precompiled(${name})
endfunction()

# One precompiled header for all, which they can share because they share flags and definitions.
function(lightwalk_precompiled name)
  if(name STREQUAL lightwalk_base)
    target_precompile_headers(${name} PRIVATE <algorithm> <array> <filesystem> <functional> <map> <memory> <optional>
                              <span> <string> <string_view> <vector> <glm/glm.hpp> <glm/gtc/matrix_transform.hpp>)
  else()
    target_precompile_headers(${name} REUSE_FROM lightwalk_base)
  endif()
endfunction()

function(lightwalk_common)
  lightwalk_library(lightwalk_base FOLDER common LINK glm::glm nlohmann_json::nlohmann_json Threads::Threads)
  target_include_directories(lightwalk_base SYSTEM PUBLIC ${PROJECT_SOURCE_DIR}/shaders)
  target_compile_definitions(lightwalk_base PUBLIC GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_RADIANS
                             GLM_ENABLE_EXPERIMENTAL)
  file(GLOB solutions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/solution)
  if(NOT solutions) # a handout
    target_compile_definitions(lightwalk_base PUBLIC LIGHTWALK_NO_SOLUTION)
  endif()
  # Reading a command line or JSON happens once in a run: that such a file compiles fast matters more.
  set_source_files_properties(
    common/app/options.cpp common/app/lists.cpp common/scene/json_lines.cpp common/scene/scene_write.cpp
    common/measure/compare_main.cpp PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON)
  lightwalk_library(lightwalk_course FOLDER common/course LINK lightwalk_base)
  lightwalk_library(lightwalk_measure FOLDER common/measure LINK lightwalk_base PkgConfig::stb)
  lightwalk_library(lightwalk_gpu FOLDER common/gpu LINK lightwalk_course Vulkan::Vulkan glslang::glslang
                    glslang::SPIRV glslang::glslang-default-resource-limits SPIRV-Tools-static ${SPIRV_CROSS})
  if(LIGHTWALK_SANITIZE OR LIGHTWALK_FUZZ)
    # Debian builds glslang without type information, which this check of the undefined-behaviour sanitizer needs.
    set_source_files_properties(${PROJECT_SOURCE_DIR}/common/gpu/compile.cpp PROPERTIES COMPILE_OPTIONS -fno-sanitize=vptr)
  endif()
  lightwalk_library(lightwalk_scene FOLDER common/scene LINK lightwalk_gpu assimp::assimp PkgConfig::stb)
  lightwalk_library(lightwalk_app FOLDER common/app LINK lightwalk_scene lightwalk_measure glfw PkgConfig::imgui
                    CLI11::CLI11)
  lightwalk_library(lightwalk_check FOLDER common/course/check LINK lightwalk_app)
  add_executable(compare ${PROJECT_SOURCE_DIR}/common/measure/compare_main.cpp)
  target_link_libraries(compare PRIVATE lightwalk_measure CLI11::CLI11)
  set_target_properties(compare PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
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
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/exercise/*.cpp ${folder}/solution/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    add_library(chapter_${chapter} STATIC ${sources})
    set_target_properties(chapter_${chapter} PROPERTIES LINKER_LANGUAGE CXX)
    lightwalk_precompiled(chapter_${chapter})
    target_include_directories(chapter_${chapter} PUBLIC ${visible})
    target_link_libraries(chapter_${chapter} PUBLIC lightwalk_app)
    foreach(name ${earlier})
      target_link_libraries(chapter_${chapter} PUBLIC chapter_${name})
    endforeach()
    if(EXISTS ${folder}/build.cmake)
      include(${folder}/build.cmake)
    endif()
    add_executable(${chapter} ${folder}/main.cpp)
    target_link_libraries(${chapter} PRIVATE chapter_${chapter})
    target_compile_definitions(${chapter} PRIVATE LIGHTWALK_CHAPTER="${chapter}")
    set_target_properties(${chapter} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/chapters)
    # Every shader in every variant is compiled and validated as part of the build, which also fills the cache.
    file(GLOB_RECURSE shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/chapters/${chapter}.shaders
                       COMMAND ${chapter} --compile-shaders
                       COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/chapters/${chapter}.shaders
                       DEPENDS ${chapter} ${shaders} VERBATIM)
    add_custom_target(shaders_${chapter} ALL DEPENDS ${PROJECT_BINARY_DIR}/chapters/${chapter}.shaders)
    list(APPEND earlier ${chapter})
  endforeach()
  add_custom_target(programs DEPENDS ${earlier})  # what a person starts, without the tests
  set(LIGHTWALK_CHAPTERS ${earlier} PARENT_SCOPE)
endfunction()

# tests/common and tests/NN_name: one Catch2 program each, and from the chapter's checks_*.cpp the program that
# ./course check runs.
function(lightwalk_tests)
  add_library(catch_main OBJECT ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
  target_compile_options(catch_main PRIVATE -O0)
  add_library(check_main OBJECT ${PROJECT_SOURCE_DIR}/common/course/check/check_main.cpp)
  target_compile_options(check_main PRIVATE -O0)
  target_link_libraries(check_main PUBLIC lightwalk_check CLI11::CLI11)
  if(Catch2_VERSION VERSION_LESS 3)
    target_link_libraries(catch_main PUBLIC Catch2::Catch2)
  else()
    target_link_libraries(catch_main PUBLIC Catch2::Catch2WithMain)
  endif()
  target_include_directories(catch_main PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  foreach(name common ${LIGHTWALK_CHAPTERS})
    set(folder ${PROJECT_SOURCE_DIR}/tests/${name})
    set(library chapter_${name})
    if(name STREQUAL common)
      set(library lightwalk_app)
    endif()
    file(GLOB checks CONFIGURE_DEPENDS ${folder}/checks_*.cpp)
    if(checks)
      add_executable(check_${name} ${checks})
      lightwalk_precompiled(check_${name})
      target_link_libraries(check_${name} PRIVATE check_main ${library} lightwalk_check)
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(sources)
      add_executable(test_${name} ${sources})
      lightwalk_precompiled(test_${name})
      target_link_libraries(test_${name} PRIVATE catch_main ${library} lightwalk_check)
      add_test(NAME unit.${name} COMMAND test_${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    endif()
    if(EXISTS ${folder}/build.cmake)
      include(${folder}/build.cmake)
    endif()
  endforeach()
endfunction()
