# Run by ctest: EXAMPLE draws PICTURE, and HAS_INK looks at it. An old picture must not pass.
file(REMOVE "${PICTURE}")
execute_process(COMMAND ${EXAMPLE} "${PICTURE}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${HAS_INK}" "${PICTURE}" COMMAND_ERROR_IS_FATAL ANY)
