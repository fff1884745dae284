find_program(PYTHON3_PROGRAM python3 PATHS /usr/bin NO_DEFAULT_PATH)  # Debian's has Debian's matplotlib
find_program(PYTHON3_PROGRAM python3 REQUIRED)
set(PYTHON3 ${PYTHON3_PROGRAM} -E -X utf8)  # as ./course starts it: PYTHON* and the locale change nothing

# The targets that a test needs: ./course test PATTERN builds no others (common/course/test/needs.py). A test without this
# needs everything.
function(lightwalk_test_needs name)
  set(needs)
  foreach(target ${ARGN})
    if(NOT TARGET ${target})
      message(FATAL_ERROR "the test ${name} needs ${target}, which is no target; its line \"# Builds:\" or its chapter's shots.json names it")
    endif()
    string(APPEND needs " ${target}")
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY LIGHTWALK_TEST_NEEDS "${name}${needs}\n")
endfunction()

# Those that a test in Python needs: the targets after "# Builds:" in it, or, for one of a chapter, the chapter, the
# chapters it names and `compare`.
function(lightwalk_script_needs name script)
  file(STRINGS ${PROJECT_SOURCE_DIR}/${script} builds REGEX "^# Builds:")
  if(builds)
    string(REGEX REPLACE "^# Builds: *(nothing)?" "" builds "${builds}")
    separate_arguments(builds)
    lightwalk_test_needs(${name} ${builds})
  elseif(script MATCHES "^tests/([0-9][0-9]_[a-z_]+)/")
    set(needs ${CMAKE_MATCH_1} compare)
    file(READ ${PROJECT_SOURCE_DIR}/${script} text)
    foreach(chapter ${LIGHTWALK_CHAPTERS})
      if(text MATCHES ${chapter})
        list(APPEND needs ${chapter})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES needs)
    lightwalk_test_needs(${name} ${needs})
  endif()
endfunction()

function(lightwalk_write_test_needs)
  get_property(needs GLOBAL PROPERTY LIGHTWALK_TEST_NEEDS)
  file(WRITE ${PROJECT_BINARY_DIR}/tests.needs "${needs}")
endfunction()
