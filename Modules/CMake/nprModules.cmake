# Finds our VTK modules by their vtk.module files, builds, wraps and installs them.

function (npr_build_modules)
  vtk_module_find_modules(module_files
    "${CMAKE_CURRENT_SOURCE_DIR}/Filters"
    "${CMAKE_CURRENT_SOURCE_DIR}/Rendering"
    "${CMAKE_CURRENT_SOURCE_DIR}/Modules")
  vtk_module_scan(
    MODULE_FILES ${module_files}
    PROVIDES_MODULES modules
    ENABLE_TESTS DEFAULT
    WANT_BY_DEFAULT ON
    HIDE_MODULES_FROM_CACHE ON)
  vtk_module_build(
    MODULES ${modules}
    PACKAGE vtkNPR
    INSTALL_EXPORT vtkNPR
    INSTALL_HEADERS ON
    TARGETS_COMPONENT development
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/vtknpr"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/vtkNPR"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
    VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}"
    TEST_DIRECTORY_NAME NONE)

  foreach (module IN LISTS modules)
    get_target_property(target ${module} ALIASED_TARGET)
    target_compile_options(${target} PRIVATE ${NPR_WARNINGS})
  endforeach ()

  if (NPR_WRAP_PYTHON)
    vtk_module_wrap_python(
      MODULES ${modules}
      INSTALL_EXPORT vtkNPRPython
      PYTHON_PACKAGE vtknpr
      MODULE_DESTINATION "${NPR_PYTHON_DESTINATION}"
      CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/vtkNPR"
      LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
      BUILD_STATIC OFF)
  endif ()

  if (BUILD_TESTING)
    foreach (file IN LISTS module_files)
      cmake_path(GET file PARENT_PATH folder)
      if (EXISTS "${folder}/Testing/CMakeLists.txt")
        add_subdirectory("${folder}/Testing")
      endif ()
    endforeach ()
  endif ()

  include(nprPackage)
endfunction ()
