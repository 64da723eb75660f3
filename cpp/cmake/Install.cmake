# What `cmake --install` puts in place, for find_package(occgrid).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS occgrid RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS occgrid_core EXPORT occgrid
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY include/occgrid
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")

set(occgrid_folder "${CMAKE_INSTALL_LIBDIR}/cmake/occgrid")
install(EXPORT occgrid FILE occgridTargets.cmake NAMESPACE occgrid::
  DESTINATION "${occgrid_folder}")
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/occgridConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES cmake/occgridConfig.cmake
  "${CMAKE_CURRENT_BINARY_DIR}/occgridConfigVersion.cmake"
  DESTINATION "${occgrid_folder}")
