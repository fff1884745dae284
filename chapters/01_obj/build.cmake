# The loaders this chapter is measured against.
target_link_libraries(chapter_${chapter} PUBLIC tinyobjloader::tinyobjloader)
