# Compiles the C++ snippets of the pages: each ```cpp block of a page becomes a function of a file of its own, after what
# Given.h gives it. The block's own #include lines come first, so it has to name all headers that it needs. Errors name
# the page and the line. The other blocks are tested elsewhere: cmake by tests/consumer/run.sh, yaml by tests/scene and
# tests/demos, python in README.md and docs/python.md by python/tests/test_docs.py.

# Writes a source file for each block of `page` into `folder`, and adds the files to the list `sources`.
function(extract_snippets page folder sources)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${page}")
  file(READ "${PROJECT_SOURCE_DIR}/${page}" rest)
  string(REGEX REPLACE "[^a-zA-Z0-9]" "_" stem "${page}")
  # A block that is none of these, or does not begin its line, would be skipped.
  string(REGEX MATCHALL "\n *(```|~~~)[^\n]+" fences "\n${rest}")
  foreach(fence ${fences})
    if(NOT fence MATCHES "^\n```(cpp|cmake|yaml)$" AND
       NOT (fence STREQUAL "\n```python" AND page MATCHES "^(README|docs/python)\\.md$"))
      string(STRIP "${fence}" fence)
      message(FATAL_ERROR "${page}: no test looks at the block that begins with ${fence}")
    endif()
  endforeach()
  set(files "${${sources}}")
  set(line 1)
  set(number 0)
  string(FIND "${rest}" "\n```cpp\n" begin)
  while(NOT begin EQUAL -1)
    math(EXPR number "${number} + 1")
    math(EXPR first "${begin} + 8")
    string(SUBSTRING "${rest}" 0 ${first} before)
    string(REGEX REPLACE "[^\n]" "" newlines "${before}")
    string(LENGTH "${newlines}" lines)
    math(EXPR line "${line} + ${lines}")
    string(SUBSTRING "${rest}" ${first} -1 rest)
    string(FIND "${rest}" "\n```" end)
    if(end EQUAL -1)
      message(FATAL_ERROR "${page}: the block that begins at line ${line} has no end")
    endif()
    string(SUBSTRING "${rest}" 0 ${end} block)
    string(SUBSTRING "${rest}" ${end} -1 rest)

    string(REGEX REPLACE "(^|\n)[^#][^\n]*" "\\1" headers "${block}")
    string(REGEX REPLACE "(^|\n)#include[^\n]*" "\\1" body "${block}")
    set(file "${folder}/${stem}_${number}.cpp")
    file(CONFIGURE OUTPUT "${file}" @ONLY CONTENT
"#line @line@ \"@page@\"
@headers@
#include \"docs/Given.h\"
void snippet@number@();
void snippet@number@()
{
#line @line@ \"@page@\"
@body@
}
")
    # For a test that runs it: tests/scene/MoveItBridgeTest.cpp
    file(CONFIGURE OUTPUT "${folder}/${stem}_${number}.inc" @ONLY CONTENT "#line @line@ \"@page@\"\n@body@\n")
    list(APPEND files "${file}")
    string(REGEX REPLACE "[^\n]" "" newlines "${block}")
    string(LENGTH "${newlines}" lines)
    math(EXPR line "${line} + ${lines}")
    string(FIND "${rest}" "\n```cpp\n" begin)
  endwhile()
  set(${sources} "${files}" PARENT_SCOPE)
endfunction()

file(GLOB pages CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
  "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/docs/*.md")
set(snippets "")
foreach(page ${pages})
  extract_snippets("${page}" "${PROJECT_BINARY_DIR}/snippets" snippets)
endforeach()
if(NOT snippets)
  message(FATAL_ERROR "No snippets were found in ${pages}")
endif()

# Compiled, not run: what a snippet does is shown by the demos.
add_library(doc_snippets OBJECT ${snippets})
# Each begins with the names of the others.
set_target_properties(doc_snippets PROPERTIES UNITY_BUILD OFF)
if(OMPL_CERTIFICATES_SANITIZE)
  # A sanitizer sees what runs.
  set_target_properties(doc_snippets PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
ompl_certificates_compile_options(doc_snippets)
# A snippet may name again what it is given, and need not use what it makes.
target_compile_options(doc_snippets PRIVATE -O0 -Wno-shadow -Wno-unused -Wno-unused-but-set-variable)
target_include_directories(doc_snippets PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(doc_snippets PRIVATE
  $<IF:$<TARGET_EXISTS:ompl_certificates_scene>,ompl_certificates::scene,ompl_certificates::ompl_certificates>)
