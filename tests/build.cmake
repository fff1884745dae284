# What ctest runs beside the Catch2 programs: shots, the goldens' teeth, Python's tests, the text.

find_program(PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)  # Debian's has Debian's matplotlib
find_program(PYTHON3 python3 REQUIRED)

function(lightwalk_python_test name label)
  add_test(NAME ${name} COMMAND ${PYTHON3} ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS "${label}" ENVIRONMENT "LIGHTWALK_BUILD=${PROJECT_BINARY_DIR}")
endfunction()

foreach(name common ${LIGHTWALK_CHAPTERS})
  if(TEST unit.${name})
    set_property(TEST unit.${name} APPEND PROPERTY LABELS unit ${name})
  endif()
endforeach()

foreach(chapter ${LIGHTWALK_CHAPTERS})
  set(list ${PROJECT_SOURCE_DIR}/tests/${chapter}/shots.json)
  # A handout has no reference to draw with; ./course check draws there.
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/shaders/${chapter}/solution
     AND NOT EXISTS ${PROJECT_SOURCE_DIR}/chapters/${chapter}/solution)
    continue()
  endif()
  if(TARGET check_${chapter})
    lightwalk_python_test(teeth.check.${chapter} "teeth;${chapter}" common/course/check_teeth.py ${chapter})
  endif()
  if(NOT EXISTS ${list})
    continue()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(READ ${list} text)
  string(SUBSTRING ${chapter} 0 2 number)
  string(JSON count LENGTH ${text} shots)
  if(count EQUAL 0)
    continue()
  endif()
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON shot GET ${text} shots ${i} name)
    lightwalk_python_test(shot.${number}.${shot} "shot;${chapter}" common/course/shots.py check ${chapter} ${shot})
    foreach(key exercises rejects)
      string(JSON wrong ERROR_VARIABLE none LENGTH ${text} shots ${i} ${key})
      if(NOT none AND wrong GREATER 0 AND NOT TEST teeth.${number}.${shot})
        lightwalk_python_test(teeth.${number}.${shot} "teeth;${chapter}" common/course/shots.py teeth ${chapter}
                              ${shot})
      endif()
    endforeach()
  endforeach()
endforeach()

# tests/*/test_NAME.py. Those of windows, and what runs none of our programs, do not run again under the sanitizers.
file(GLOB scripts CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests/*/test_*.py)
foreach(script ${scripts})
  string(REGEX REPLACE "^tests/(.*)/test_(.*)\\.py$" "\\1.\\2" name ${script})
  if(name MATCHES "window")
    lightwalk_python_test(window.${name} window ${script})
  elseif(name STREQUAL "common.course")
    lightwalk_python_test(text.course text ${script})
    set_tests_properties(text.course PROPERTIES COST 60)  # the longest: first
  else()
    lightwalk_python_test(python.${name} unit ${script})
  endif()
endforeach()
lightwalk_python_test(text.tree text common/course/text_check.py)
