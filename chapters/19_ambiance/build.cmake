# A panel of its own: Dear ImGui's headers. Its code is in the library already, and there must be one of it only.
target_include_directories(chapter_19_ambiance SYSTEM PUBLIC ${imgui_INCLUDE_DIRS})
# The outlines of titles.
target_link_libraries(chapter_19_ambiance PRIVATE PkgConfig::stb)
