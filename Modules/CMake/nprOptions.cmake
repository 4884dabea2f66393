# What a user may switch at configure time, and how our own code is compiled.
include(GNUInstallDirs)

option(BUILD_SHARED_LIBS "Build shared libraries (static ones are not supported)" ON)
if (NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR "vtkNPR can only be built as shared libraries: the object factories and the "
    "private dependencies of static ones would be left to every program that links them. "
    "Configure with -DBUILD_SHARED_LIBS=ON.")
endif ()
option(BUILD_TESTING "Build the tests, examples and benchmarks" ON)
option(NPR_WRAP_PYTHON "Build the Python package vtknpr" ON)
set(NPR_PYTHON_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages"
  CACHE STRING "Where the Python package goes, relative to the prefix")
option(NPR_USE_OPENVDB "Read OpenVDB files" ON)
option(NPR_USE_CAIRO "Write drawings as PDF, by cairo and qpdf" ON)
option(NPR_USE_EMBREE "Find hidden lines by Embree's rays" ON)
option(NPR_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" OFF)
set(NPR_SANITIZE "" CACHE STRING "Sanitizers for our own code, such as address,undefined or thread")

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

find_program(NPR_CCACHE ccache)
mark_as_advanced(NPR_CCACHE)
if (NPR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${NPR_CCACHE}")
endif ()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
# Our libraries find each other in any prefix: linkers write RUNPATH, which what a library links
# does not inherit. For its Python modules VTK appends the way to the libraries.
set(CMAKE_INSTALL_RPATH "$ORIGIN")

if (NPR_SANITIZE)
  add_compile_options("-fsanitize=${NPR_SANITIZE}" -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${NPR_SANITIZE}")
endif ()

# Warnings stand on the targets that we write, never on the wrappers that VTK generates.
# No -Wpedantic: it rejects the semicolon after VTK 9.1's vtkTypeMacro, which later versions require.
set(NPR_WARNINGS -Wall -Wextra -Wshadow -Wno-unused-parameter)
if (NPR_WARNINGS_AS_ERRORS)
  list(APPEND NPR_WARNINGS -Werror)
endif ()
