# How our own targets are compiled. Nothing here reaches a user of the installed library.

# No -march=native, here or by default: it changes the alignment of Eigen's types, and with it the layout of FCL's
# objects, which must be the one that the installed OMPL and FCL were built with.
if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

  # Several files are compiled as one: most of the time goes into headers, so a whole build is faster. A change
  # of one file then compiles its neighbors, too; with this OFF, it does not.
  option(CMAKE_UNITY_BUILD "Compile several files as one" ON)
  # More files at once compile faster still, but GCC inlines less in large files: not where speed counts. With
  # sanitizers it counts nowhere.
  if(OMPL_CERTIFICATES_SANITIZE AND NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
  endif()

  find_program(CCACHE_PROGRAM ccache)
  mark_as_advanced(CCACHE_PROGRAM)
  if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # The sloppiness is what ccache asks for before it caches anything that uses a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
  endif()
endif()

if(OMPL_CERTIFICATES_SANITIZE)
  add_compile_options(-fsanitize=${OMPL_CERTIFICATES_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${OMPL_CERTIFICATES_SANITIZE})
  # Eigen would allocate in another way than in OMPL's library, which frees what it has inlined there.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  # A run that looks for errors looks with all assertions on, Eigen's and the standard library's among them.
  add_compile_options(-UNDEBUG)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

# Instrumented code compiles twice as fast without optimization: for what takes longer to compile than its tests to run.
function(ompl_certificates_keep_plain target)
  if(OMPL_CERTIFICATES_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# Language level and warnings of one of our targets, library or program.
function(ompl_certificates_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    $<$<BOOL:${OMPL_CERTIFICATES_WERROR}>:-Werror>
    # What GCC's optimizer believes to see inside Eigen is often wrong.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-maybe-uninitialized>
    # A class may have members of a type of its file's own. Compiled with others, a file looks like a header.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
    # OMPL's log messages and GoogleTest's failures then name src/..., wherever it was built.
    "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/="
    # For ccache to see into a precompiled header of GCC's.
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# What our libraries have in common; `name` is the exported one: ompl_certificates::<name>, by default the target's.
function(ompl_certificates_library target)
  set(name ${target})
  if(ARGC GREATER 1)
    set(name ${ARGV1})
  endif()
  add_library(ompl_certificates::${name} ALIAS ${target})
  ompl_certificates_compile_options(${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE "${PROJECT_SOURCE_DIR}/src")
  # Fails the build, not a user's program, if the core reaches up into the scene library. Sanitizers need it off.
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT OMPL_CERTIFICATES_SANITIZE)
    target_link_options(${target} PRIVATE LINKER:--no-undefined)
  endif()
  # The library calls its own functions, not those of a program that was compiled otherwise.
  target_link_options(${target} PRIVATE LINKER:-Bsymbolic-functions)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    # Until 1.0 a minor release may break the ABI.
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN")
endfunction()
