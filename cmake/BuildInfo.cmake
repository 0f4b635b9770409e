# SPDX-License-Identifier: Apache-2.0
# Run at every build (cmake -P): writes OUTPUT from TEMPLATE with the commit of SOURCE_DIR; untouched when nothing changed.
execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE GASJET_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE git_failed)
if(git_failed)
  set(GASJET_COMMIT "unknown")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
