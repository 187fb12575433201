# Headers, libraries, programs and the CMake package; find_package(ompl_certificates [COMPONENTS octomap scene pictures])
# finds it again. Each rule names the package of cmake/Package.cmake that its files go to; `cmake --install` takes all.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/ompl_certificates")

# Installs libraries and adds them to an exported set.
function(install_libraries set)
  install(TARGETS ${ARGN} EXPORT ${set}
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE COMPONENT dev)
endfunction()

install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev
  PATTERN "scene" EXCLUDE PATTERN "pictures" EXCLUDE)
install_libraries(ompl_certificatesTargets ompl_certificates ompl_certificates_neighbors)
if(TARGET ompl_certificates_octomap)
  install_libraries(ompl_certificatesTargets ompl_certificates_octomap)
endif()
install(EXPORT ompl_certificatesTargets NAMESPACE ompl_certificates:: DESTINATION "${package_dir}" COMPONENT dev)

if(TARGET ompl_certificates_scene)
  install(DIRECTORY include/ompl_certificates/scene include/ompl_certificates/pictures
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ompl_certificates" COMPONENT dev)
  install_libraries(ompl_certificates_sceneTargets ompl_certificates_scene ompl_certificates_pictures)
  install(EXPORT ompl_certificates_sceneTargets NAMESPACE ompl_certificates:: DESTINATION "${package_dir}"
    COMPONENT dev)
endif()

# The programs that serve users; they find the libraries next to them, wherever both are moved.
file(RELATIVE_PATH libraries_from_programs "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
if(TARGET certificates)
  set_target_properties(certificates PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_programs}")
  install(TARGETS certificates RUNTIME COMPONENT tools)
  foreach(program IN LISTS ompl_certificates_programs)
    if(NOT program STREQUAL certificates)
      # A link to it, which stays one
      install(FILES "$<TARGET_FILE_DIR:certificates>/${program}" TYPE BIN COMPONENT tools)
    endif()
    install(FILES "${PROJECT_BINARY_DIR}/completions/${program}"
      DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT tools)
  endforeach()
endif()

configure_package_config_file(cmake/ompl_certificatesConfig.cmake.in ompl_certificatesConfig.cmake
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(ompl_certificatesConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/ompl_certificatesConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/ompl_certificatesConfigVersion.cmake"
  cmake/OmplTarget.cmake
  DESTINATION "${package_dir}" COMPONENT dev)

install(FILES package.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/ompl_certificates" COMPONENT dev)
install(FILES CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT dev)
# Debian's packages have them under other names.
install(FILES LICENSE CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT documents)

