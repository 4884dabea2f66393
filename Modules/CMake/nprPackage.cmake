# The package config of the install tree: find_package(vtkNPR) brings VTK with the same components.
include(CMakePackageConfigHelpers)
set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/vtkNPR")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/vtkNPRConfig.cmake.in" "${CMAKE_BINARY_DIR}/vtkNPRConfig.cmake"
  INSTALL_DESTINATION "${package_destination}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/vtkNPRConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_BINARY_DIR}/vtkNPRConfig.cmake" "${CMAKE_BINARY_DIR}/vtkNPRConfigVersion.cmake"
  DESTINATION "${package_destination}" COMPONENT development)
