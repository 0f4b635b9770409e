# SPDX-License-Identifier: Apache-2.0
# Run at every build (cmake -P): writes OUTPUT from TEMPLATE with the commit of SOURCE_DIR; untouched when nothing changed.
execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} describe --always --abbrev=12
  OUTPUT_VARIABLE GASJET_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE git_failed)
if(git_failed)
  set(GASJET_COMMIT "unknown")
else()
  # Pages and charts that a build has just written do not change what it is.
  execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} diff --quiet HEAD -- . :!docs
    ERROR_QUIET RESULT_VARIABLE dirty)
  if(dirty)
    string(APPEND GASJET_COMMIT "-dirty")
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
