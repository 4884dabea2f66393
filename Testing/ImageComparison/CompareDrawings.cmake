# Run by ctest: DRAW writes NAME.svg and NAME.pdf; a program for each makes pixels of them, which
# COMPARE (npr-compare-images) must find alike. Old files must not pass.
foreach (program rsvg-convert pdftoppm)
  find_program(${program} ${program})
  if (NOT ${program})
    message(FATAL_ERROR "${program} was not found (Debian packages librsvg2-bin, poppler-utils).")
  endif ()
endforeach ()
file(REMOVE "${NAME}.svg" "${NAME}.pdf" "${NAME}.svg.png" "${NAME}.pdf.png")
execute_process(COMMAND ${DRAW} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${rsvg-convert}" -b white -d 150 -p 150 "${NAME}.svg" -o "${NAME}.svg.png"
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${pdftoppm}" -r 150 -png -singlefile "${NAME}.pdf" "${NAME}.pdf"
  COMMAND_ERROR_IS_FATAL ANY)
# The programs' antialiasing differs at thin ends of strokes.
execute_process(COMMAND "${COMPARE}" "${NAME}.svg.png" "${NAME}.pdf.png"
  --missing-piece 20 --extra-piece 20 --ink-amount 0.08 --local-ssim 0
  --difference "${NAME}.difference.png" COMMAND_ERROR_IS_FATAL ANY)
