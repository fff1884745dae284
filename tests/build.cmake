# What ctest runs beside the Catch2 programs: checks, stability, studies, needs, shots, the goldens' teeth, Python's
# tests, the text.

find_program(PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)  # Debian's has Debian's matplotlib
find_program(PYTHON3 python3 REQUIRED)

function(lightwalk_python_test name label)
  add_test(NAME ${name} COMMAND ${PYTHON3} ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set(environment "LIGHTWALK_BUILD=${PROJECT_BINARY_DIR}")
  if(LIGHTWALK_SANITIZE)
    list(APPEND environment "LSAN_OPTIONS=print_suppressions=0")  # a run that ends well says nothing
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${label}" ENVIRONMENT "${environment}")
endfunction()

# A check compiles many small shaders and runs each for a few values: LLVM need not make them fast (lavapipe).
function(lightwalk_check_test name label)
  lightwalk_python_test(${name} "${label}" ${ARGN})
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT GALLIVM_PERF=nopt)
endfunction()

foreach(name common ${LIGHTWALK_CHAPTERS})
  if(TEST unit.${name})
    set_property(TEST unit.${name} APPEND PROPERTY LABELS unit ${name})
  endif()
endforeach()

if("$ENV{CI}" STREQUAL "true") # whose selection has no teeth (common/course/test/run_tests.py)
  set(no_teeth --no-teeth)
endif()

foreach(chapter ${LIGHTWALK_CHAPTERS})
  set(list ${PROJECT_SOURCE_DIR}/tests/${chapter}/shots.json)
  # A handout has no reference to draw with; ./course check draws there.
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/shaders/${chapter}/solution
     AND NOT EXISTS ${PROJECT_SOURCE_DIR}/chapters/${chapter}/solution)
    continue()
  endif()
  string(SUBSTRING ${chapter} 0 2 number)
  if(TARGET check_${chapter})
    lightwalk_check_test(check.${number} "check;${chapter}" common/course test.results check ${chapter})
    lightwalk_check_test(teeth.check.${chapter} "teeth;${chapter}" common/course test.check_teeth ${chapter})
    if(EXISTS ${PROJECT_SOURCE_DIR}/tests/${chapter}/variants AND NOT LIGHTWALK_SANITIZE)
      lightwalk_check_test(variants.${number} "teeth;${chapter}" common/course test.check_variants ${chapter})
    endif()
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/tests/${chapter}/test_stability.cpp)
    lightwalk_python_test(stability.${number} "stability;${chapter}" common/course test.results stability ${chapter})
    set_tests_properties(stability.${number} PROPERTIES COST 100)
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/chapters/${chapter}/study.json)
    lightwalk_python_test(study.${number} "study;${chapter}" common/course test.study_test ${chapter})
    set_tests_properties(study.${number} PROPERTIES COST 40)
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/tests/${chapter}/needs.json)
    lightwalk_python_test(need.${number} "study;${chapter}" common/course test.need_test ${chapter})
    set_tests_properties(need.${number} PROPERTIES RUN_SERIAL ON)  # a rule that times frames, judged by their times
  endif()
  if(NOT EXISTS ${list})
    continue()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(READ ${list} text)
  string(JSON count LENGTH ${text} shots)
  if(count EQUAL 0)
    continue()
  endif()
  lightwalk_python_test(pictures.${number} "shot;${chapter}" common/course shots.draw_shots ${chapter} ${no_teeth})
  set_tests_properties(pictures.${number} PROPERTIES COST 200 TIMEOUT 900)  # before what compares them
  if(TEST variants.${number})  # which compares with them too
    set_tests_properties(variants.${number} PROPERTIES COST 100 DEPENDS pictures.${number})
  endif()
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON shot GET ${text} shots ${i} name)
    lightwalk_python_test(shot.${number}.${shot} "shot;${chapter}" common/course test.shots check ${chapter} ${shot})
    set_tests_properties(shot.${number}.${shot} PROPERTIES DEPENDS pictures.${number})
    foreach(key exercises rejects)
      string(JSON wrong ERROR_VARIABLE none LENGTH ${text} shots ${i} ${key})
      if(NOT none AND wrong GREATER 0 AND NOT TEST teeth.${number}.${shot})
        lightwalk_python_test(teeth.${number}.${shot} "teeth;${chapter}" common/course test.shots teeth ${chapter}
                              ${shot})
        set_tests_properties(teeth.${number}.${shot} PROPERTIES DEPENDS pictures.${number})
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
    # One after the other, from the beginning: they wait more than they work, beside tests that take all there is.
    set_tests_properties(window.${name} PROPERTIES COST 900 TIMEOUT 600 RESOURCE_LOCK window)
  elseif(name MATCHES "common.(chart|course|elsewhere|grade|live|minimal|pages|report|slides|study)")
    string(REPLACE "common." "text." name ${name})
    lightwalk_python_test(${name} text ${script})
    if(name MATCHES "course|grade|live|pages|chart")
      set_tests_properties(${name} PROPERTIES COST 60)  # the longest: first
    endif()
    if(name MATCHES "live_browser")
      set_tests_properties(${name} PROPERTIES DEPENDS text.pages)  # which leaves the pages there
    endif()
    if(name MATCHES "live_chapter")
      set_tests_properties(${name} PROPERTIES LABELS "text;study" COST 800 TIMEOUT 1800)  # it checks all exercises of a chapter
    endif()
  elseif(name MATCHES "knobs$")
    foreach(chapter ${LIGHTWALK_CHAPTERS})
      string(SUBSTRING ${chapter} 0 2 number)
      lightwalk_python_test(python.${name}.${number} unit ${script} KnobsTest.test_${chapter})
      set_tests_properties(python.${name}.${number} PROPERTIES COST 800 TIMEOUT 900)
    endforeach()
  else()
    lightwalk_python_test(python.${name} unit ${script})
    set_tests_properties(python.${name} PROPERTIES COST 100)  # so that the shots, which take a blink each, come last
    if(name MATCHES "equal_methods$")
      set_tests_properties(python.${name} PROPERTIES COST 800 TIMEOUT 900)  # minutes: beside all others, not behind them
    endif()
  endif()
endforeach()
lightwalk_python_test(text.tree text common/course test.text_check)
file(GLOB studies CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/studies/*.json)
if(studies)
  lightwalk_python_test(text.charts text common/course test.results charts)
endif()
