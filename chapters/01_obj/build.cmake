# The two public parsers that the loaders are measured against.
target_link_libraries(chapter_01_obj PUBLIC tinyobjloader::tinyobjloader assimp::assimp)
# The textbook's parser has names of the fast one, which is an answer to exercises: a handout has it compiled.
set_source_files_properties(${folder}/textbook.cpp ${folder}/scan.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
