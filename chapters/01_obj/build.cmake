# The two public parsers that the loaders are measured against.
target_link_libraries(chapter_01_obj PUBLIC tinyobjloader::tinyobjloader assimp::assimp)
# A newcomer waits for this chapter. The textbook's parser has names of the fast one.
lightwalk_compiled_together(chapter_01_obj)
set_source_files_properties(${folder}/textbook.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
