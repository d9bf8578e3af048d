# cmake -DSOURCE=folder -DFILE=file -P revision.cmake
# Writes which commit a folder's files are of, or "unknown" outside git. A file that says so already
# is left alone.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision unknown)
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "${revision}\n")
