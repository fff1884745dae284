# Sixty times of two films, each from a cold start too, take minutes: with the studies, which CI leaves out.
add_test(NAME any_time.19 COMMAND test_19_ambiance "[.long]" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
set_tests_properties(any_time.19 PROPERTIES LABELS "study;19_ambiance" COST 300 TIMEOUT 3000)
lightwalk_test_needs(any_time.19 test_19_ambiance)

# A throw-away chapter behind this one: a world is tried elsewhere than in its chapter (test_worlds.py).
lightwalk_program(anywhere ${CMAKE_CURRENT_LIST_DIR}/compositions/anywhere.cpp chapter_19_ambiance)
target_compile_definitions(anywhere PRIVATE LIGHTWALK_CHAPTER="99_anywhere")
lightwalk_compiled_fast(anywhere)
