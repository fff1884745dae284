# Tests write pictures and compressed meshes to read them back.
target_link_libraries(test_common PRIVATE PkgConfig::stb ${WEBP} ${DRACO} ${MESHOPTIMIZER})

# Fuzzing: cmake --preset fuzz, then build/fuzz/tests/fuzz_scene tests/common/corpus/scene
if(LIGHTWALK_FUZZ)
  foreach(name fuzz_scene fuzz_image fuzz_json fuzz_model)
    add_executable(${name} ${CMAKE_CURRENT_LIST_DIR}/fuzz/${name}.cpp)
    target_link_libraries(${name} PRIVATE lightwalk)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  endforeach()
endif()

# docs/minimal: each method at its smallest. The programs run in tests/common/test_minimal.py.
file(GLOB minimal CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/minimal/*.cpp)
foreach(source ${minimal})
  get_filename_component(name ${source} NAME_WE)
  add_executable(minimal_${name} ${source})
  target_link_libraries(minimal_${name} PRIVATE glm::glm)
  set_target_properties(minimal_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/minimal
                                                   OUTPUT_NAME ${name})
endforeach()
# The programs of docs/vulkan.md and docs/descriptors.md, with the shaders that they read beside them; a fragment shader's
# variant is called like the macro that it is compiled with.
function(minimal_shader program source spirv)
  add_custom_command(
    OUTPUT ${PROJECT_BINARY_DIR}/minimal/${spirv}
    COMMAND glslangValidator --quiet -V --target-env vulkan1.3 ${ARGN} -o ${PROJECT_BINARY_DIR}/minimal/${spirv}
            ${PROJECT_SOURCE_DIR}/docs/minimal/${source}
    DEPENDS ${PROJECT_SOURCE_DIR}/docs/minimal/${source})
  target_sources(minimal_${program} PRIVATE ${PROJECT_BINARY_DIR}/minimal/${spirv})
endfunction()
foreach(stage vert frag)
  minimal_shader(00_vulkan 00_vulkan.${stage} 00_vulkan.${stage}.spv)
endforeach()
minimal_shader(00_descriptors 00_descriptors.vert 00_descriptors.vert.spv)
foreach(variant ONE LAYERS_BY_OFFSET LAYERS_BY_BUFFER TABLE_BY_CONSTANT TABLE_BY_BUFFER)
  minimal_shader(00_descriptors 00_descriptors.frag 00_descriptors.${variant}.spv -D${variant})
endforeach()
target_link_libraries(minimal_00_vulkan PRIVATE Vulkan::Vulkan glfw)
target_link_libraries(minimal_00_descriptors PRIVATE Vulkan::Vulkan)
file(GLOB minimal CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/minimal/*.cpp)
add_executable(test_minimal ${minimal})
target_link_libraries(test_minimal PRIVATE catch_main lightwalk_check)
lightwalk_compiled_fast(test_minimal)
add_test(NAME unit.minimal COMMAND test_minimal WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
set_tests_properties(unit.minimal PROPERTIES LABELS unit)
lightwalk_test_needs(unit.minimal test_minimal)
