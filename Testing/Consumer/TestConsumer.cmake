# Run by ctest; see CMakeLists.txt.
function (step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed:\n${text}")
  endif ()
  message("${what}:\n${text}")
endfunction ()

# Nothing of an earlier run may help, and no path that whoever runs the tests has set.
file(REMOVE_RECURSE "${WORK}")
unset(ENV{LD_LIBRARY_PATH})
unset(ENV{PYTHONPATH})
step("Installing" "${CMAKE_COMMAND}" --install "${BUILD_TREE}" --prefix "${WORK}/prefix")

# A path into the source or build tree works on this machine only.
file(GLOB_RECURSE package_files "${WORK}/prefix/*.cmake" "${WORK}/prefix/*.h")
foreach (file IN LISTS package_files)
  file(READ "${file}" text)
  foreach (tree IN ITEMS "${BUILD_TREE}" "${SOURCE_TREE}")
    # The prefix itself lies in the build tree, but no installed file may name it, either.
    string(FIND "${text}" "${tree}/" at)
    if (NOT at EQUAL -1)
      message(FATAL_ERROR "The installed file ${file} names ${tree}")
    endif ()
  endforeach ()
endforeach ()

set(flags)
if (SANITIZE)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE}")
endif ()
step("Configuring the consumer" "${CMAKE_COMMAND}" -G "${GENERATOR}"
  -S "${CMAKE_CURRENT_LIST_DIR}/Project" -B "${WORK}/build"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_C_COMPILER=${CC}"
  "-DVTK_DIR=${VTK_DIR}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" ${flags})
step("Building the consumer" "${CMAKE_COMMAND}" --build "${WORK}/build")
step("Running the consumer's filters" "${WORK}/build/curvature")
step("Running the consumer's picture" "${WORK}/build/picture")

step("Running the installed command" "${WORK}/prefix/${BIN}/npr" doctor)
if (PYTHON_PATH)
  step("Importing the installed package"
    "${CMAKE_COMMAND}" -E env "PYTHONPATH=${WORK}/prefix/${PYTHON_PATH}"
    "${PYTHON}" -c "print(__import__('vtknpr').__file__)")
endif ()
