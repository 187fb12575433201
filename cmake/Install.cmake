# Headers, libraries, programs and the CMake package; find_package(ompl_certificates [COMPONENTS octomap scene pictures]) finds it again.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/ompl_certificates")

install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" PATTERN "scene" EXCLUDE PATTERN "pictures" EXCLUDE)
install(TARGETS ompl_certificates ompl_certificates_neighbors EXPORT ompl_certificatesTargets)
if(TARGET ompl_certificates_octomap)
  install(TARGETS ompl_certificates_octomap EXPORT ompl_certificatesTargets)
endif()
install(EXPORT ompl_certificatesTargets NAMESPACE ompl_certificates:: DESTINATION "${package_dir}")

if(TARGET ompl_certificates_scene)
  install(DIRECTORY include/ompl_certificates/scene include/ompl_certificates/pictures
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ompl_certificates")
  install(TARGETS ompl_certificates_scene ompl_certificates_pictures EXPORT ompl_certificates_sceneTargets)
  install(EXPORT ompl_certificates_sceneTargets NAMESPACE ompl_certificates:: DESTINATION "${package_dir}")
endif()

# The programs that serve users; they find the libraries next to them, wherever both are moved.
file(RELATIVE_PATH libraries_from_programs "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
foreach(program plan_team benchmark_team generate_scene certificate_experiment)
  if(TARGET ${program})
    set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_programs}")
    install(TARGETS ${program})
  endif()
endforeach()

configure_package_config_file(cmake/ompl_certificatesConfig.cmake.in ompl_certificatesConfig.cmake
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(ompl_certificatesConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/ompl_certificatesConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/ompl_certificatesConfigVersion.cmake"
  cmake/OmplTarget.cmake
  DESTINATION "${package_dir}")

install(FILES package.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/ompl_certificates")
install(FILES LICENSE CITATION.cff CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
