# The package config of the install tree: find_package(vtkNPR) brings VTK with the same components,
# and of the same minor version, since VTK keeps no binary interface from one to the next.
include(CMakePackageConfigHelpers)
math(EXPR next_minor "${VTK_MINOR_VERSION} + 1")
set(NPR_VTK_VERSIONS
  "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}...<${VTK_MAJOR_VERSION}.${next_minor}")
set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/vtkNPR")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/vtkNPRConfig.cmake.in" "${CMAKE_BINARY_DIR}/vtkNPRConfig.cmake"
  INSTALL_DESTINATION "${package_destination}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/vtkNPRConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_BINARY_DIR}/vtkNPRConfig.cmake" "${CMAKE_BINARY_DIR}/vtkNPRConfigVersion.cmake"
  DESTINATION "${package_destination}" COMPONENT development)
