# Debian packages, made by scripts/package.sh through CPack, with -DOMPL_CERTIFICATES_DEBIAN=ON. Four, of the components
# that the install rules name:
#   runtime  libompl-certificates<soversion>   the libraries
#   dev      libompl-certificates-dev          headers, CMake package
#   tools    ompl-certificates-tools           the programs
#   python   python3-ompl-certificates         the Python module
set(soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ompl-certificates)
set(CPACK_PACKAGE_VENDOR "The ompl_certificates authors")
set(CPACK_PACKAGE_CONTACT "The ompl_certificates authors <ompl_certificates@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL runtime dev tools python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "libompl-certificates${soversion}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
# Packages that link these libraries depend on this version of them, and ldconfig is told of them.
set(debian "${PROJECT_BINARY_DIR}/debian")
foreach(part "" _neighbors _octomap _scene _pictures)
  string(APPEND shlibs "libompl_certificates${part} ${soversion} "
    "${CPACK_DEBIAN_RUNTIME_PACKAGE_NAME} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})\n")
endforeach()
file(WRITE "${debian}/shlibs" "${shlibs}")
file(WRITE "${debian}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${debian}/shlibs" "${debian}/triggers")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libompl-certificates-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DEPENDS runtime)
# Boost's filesystem and system are named by OMPL's CMake package, which does not depend on them.
string(CONCAT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libompl-dev, libfcl-dev, libccd-dev, libeigen3-dev, libboost-dev, libboost-serialization-dev, "
  "libboost-filesystem-dev, libboost-system-dev, liboctomap-dev, libyaml-cpp-dev, libpugixml-dev, libpng-dev, "
  "liburdfdom-dev")
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME ompl-certificates-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_COMPONENT_TOOLS_DEPENDS runtime)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ompl-certificates)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
find_package(Python REQUIRED COMPONENTS Interpreter)
# The module is for one minor version of Python, as its file name says.
math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), "
  "python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")

# Else CPack begins all descriptions with the project's.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(about
"A state space, a validity checker and a motion validator for OMPL. They
remember every measured clearance as a ball of the workspace that is free.
So most collision checks of a team of robots need not be made.
")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "plan for teams of robots by safety certificates
${about}
This package has the shared libraries.")
set(CPACK_COMPONENT_DEV_DESCRIPTION "plan for teams of robots by safety certificates (development)
${about}
This package has the headers and the package for CMake.")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "plan for teams of robots by safety certificates (programs)
${about}
This package has the program certificates. Among other things it plans for
the scene of a file.")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "plan for teams of robots by safety certificates (Python 3)
${about}
This package has the Python module, which takes and gives numpy arrays.")

# What Debian wants in each package, its licence and its changes, and pages of manual for programs
find_program(GZIP_PROGRAM gzip REQUIRED)
find_program(HELP2MAN_PROGRAM help2man REQUIRED)
mark_as_advanced(GZIP_PROGRAM HELP2MAN_PROGRAM)
configure_file(cmake/debian/changelog.in "${debian}/changelog.Debian" @ONLY)
configure_file(CHANGELOG.md "${debian}/changelog" COPYONLY)
execute_process(COMMAND "${GZIP_PROGRAM}" -9nf changelog.Debian changelog
  WORKING_DIRECTORY "${debian}" COMMAND_ERROR_IS_FATAL ANY)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  install(FILES cmake/debian/copyright "${debian}/changelog.Debian.gz" "${debian}/changelog.gz"
    DESTINATION "share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}" COMPONENT ${component})
endforeach()
foreach(program IN LISTS ompl_certificates_programs)
  add_custom_command(OUTPUT "${debian}/${program}.1.gz"
    # help2man gives the program's path to a shell, so that it must have no spaces.
    COMMAND sh -c "help2man --no-info --output \"$1.1\" --name \"$(./$0 --help | head -n 1)\" ./$0"
      ${program} "${debian}/${program}"
    COMMAND "${GZIP_PROGRAM}" -9nf "${debian}/${program}.1"
    DEPENDS certificates
    WORKING_DIRECTORY $<TARGET_FILE_DIR:certificates>
    VERBATIM)
  list(APPEND manuals "${debian}/${program}.1.gz")
endforeach()
add_custom_target(manuals ALL DEPENDS ${manuals})
install(FILES ${manuals} DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)

include(CPack)
