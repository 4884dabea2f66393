# Helpers that declare tests. A test is one function `int TestXxx(int argc, char* argv[])` in
# TestXxx.cxx beside the module it tests, as in VTK, and one line here.

set(NPR_TEST_OUTPUT "${CMAKE_BINARY_DIR}/Testing/Output")
file(MAKE_DIRECTORY "${NPR_TEST_OUTPUT}")
set(NPR_TEST_MODELS "${CMAKE_BINARY_DIR}/Testing/Models")

# No test opens a window on the screen of whoever runs it. OSMesa needs no driver at all; Mesa 25.1
# and later are without it.
find_library(osmesa_library NAMES libOSMesa.so.8 NO_CACHE)
if (osmesa_library)
  set(offscreen osmesa)
else ()
  set(offscreen egl)
endif ()
set(NPR_TEST_ENVIRONMENT
  "NPR_OFFSCREEN=${offscreen}" "LP_NUM_THREADS=2" "NPR_MODELS=${NPR_TEST_MODELS}")

# npr_add_tests(NAME <module library, such as vtkNPRFiltersLines>
#   SOURCES TestA.cxx TestB.cxx ... [LIBRARIES <targets>...])
#
# Builds one test program and adds a test `<NAME>.TestA` for each source. Each is called with
# `-B <Testing/Data/Baseline beside it> -T <folder for output> -D <Testing/Data of the project>`.
function (npr_add_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;LIBRARIES")
  create_test_sourcelist(sources "${arg_NAME}Tests.cxx" ${arg_SOURCES})
  add_executable(${arg_NAME}Tests ${sources})
  target_link_libraries(${arg_NAME}Tests PRIVATE ${arg_LIBRARIES})
  target_compile_options(${arg_NAME}Tests PRIVATE ${NPR_WARNINGS})
  # Object factories, such as the one that makes an OpenGL window of a vtkRenderWindow.
  set(modules ${arg_LIBRARIES})
  list(FILTER modules INCLUDE REGEX "^(VTK|NPR)::")
  vtk_module_autoinit(TARGETS ${arg_NAME}Tests MODULES ${modules})
  foreach (source IN LISTS arg_SOURCES)
    cmake_path(GET source STEM test)
    add_test(NAME "${arg_NAME}.${test}"
      COMMAND ${arg_NAME}Tests ${test}
        -B "${CMAKE_CURRENT_SOURCE_DIR}/../Data/Baseline"
        -T "${NPR_TEST_OUTPUT}" -D "${CMAKE_SOURCE_DIR}/Testing/Data")
    set_tests_properties("${arg_NAME}.${test}" PROPERTIES
      ENVIRONMENT "${NPR_TEST_ENVIRONMENT}" TIMEOUT 300)
  endforeach ()
endfunction ()

# npr_tests_need_models(<test>...): such tests read models that Testing/Data/fetch brings, by
# npr::TestModel() (nprTestModels.h, target nprTestModels), and are skipped where it can not.
function (npr_tests_need_models)
  set_tests_properties(${ARGV} PROPERTIES FIXTURES_REQUIRED NprModels SKIP_RETURN_CODE 125)
endfunction ()

# npr_compare_drawings(NAME <test> FILES <path without ending> COMMAND <what draws>): the command
# writes the path with .svg and with .pdf, and both must look alike.
function (npr_compare_drawings)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;FILES" "COMMAND")
  add_test(NAME "${arg_NAME}"
    COMMAND "${CMAKE_COMMAND}" "-DDRAW=${arg_COMMAND}" "-DNAME=${arg_FILES}"
      "-DCOMPARE=$<TARGET_FILE:npr-compare-images>"
      -P "${CMAKE_SOURCE_DIR}/Testing/ImageComparison/CompareDrawings.cmake")
  set_tests_properties("${arg_NAME}" PROPERTIES ENVIRONMENT "${NPR_TEST_ENVIRONMENT}" TIMEOUT 120)
endfunction ()
