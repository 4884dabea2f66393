# Run by ctest: DRAW writes into FOLDER a PDF Whole.pdf and, for some of its layers, one with that
# layer switched off (Layer1-off.pdf) and one drawn without it (Layer1-without.pdf). Those two must
# have the same pixels, and others than the whole. Old files must not pass.
find_program(pdftoppm pdftoppm)
if (NOT pdftoppm)
  message(FATAL_ERROR "pdftoppm was not found (Debian package poppler-utils).")
endif ()
file(GLOB old "${FOLDER}/*.pdf" "${FOLDER}/*.png")
if (old)
  file(REMOVE ${old})
endif ()
execute_process(COMMAND ${DRAW} COMMAND_ERROR_IS_FATAL ANY)

# Makes pixels of a PDF, and hash their hash.
function (draw_pixels name hash)
  execute_process(
    COMMAND "${pdftoppm}" -r 150 -png -singlefile "${FOLDER}/${name}.pdf" "${FOLDER}/${name}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(SHA256 "${FOLDER}/${name}.png" sum)
  set(${hash} "${sum}" PARENT_SCOPE)
endfunction ()

draw_pixels(Whole whole)
file(GLOB switched RELATIVE "${FOLDER}" "${FOLDER}/*-off.pdf")
if (NOT switched)
  message(FATAL_ERROR "No drawing with a layer switched off in ${FOLDER}.")
endif ()
foreach (file IN LISTS switched)
  string(REPLACE "-off.pdf" "" name "${file}")
  draw_pixels("${name}-off" off)
  draw_pixels("${name}-without" without)
  if (off STREQUAL whole)
    message(FATAL_ERROR "${FOLDER}/${file}: no pixel changes where the layer is switched off.")
  endif ()
  if (NOT off STREQUAL without)
    message(FATAL_ERROR "${FOLDER}/${name}-off.png and -without.png differ: the layer has not all "
      "of its lines, or those of others.")
  endif ()
endforeach ()
