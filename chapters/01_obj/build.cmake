# The two public parsers that the loaders are measured against.
target_link_libraries(chapter_01_obj PUBLIC tinyobjloader::tinyobjloader assimp::assimp)
