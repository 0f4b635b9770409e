# SPDX-License-Identifier: Apache-2.0
# Run at every build (cmake -P): writes OUTPUT from TEMPLATE with the commit of SOURCE_DIR; untouched when nothing changed.
# A source archive names its commit itself; a clone asks git, unless SOURCE_DIR is part of another repository.
file(READ ${SOURCE_DIR}/cmake/archive_commit.txt archived)
string(REGEX MATCH "^[0-9a-f]+" GASJET_COMMIT "${archived}")
set(git git -c safe.directory=* -C ${SOURCE_DIR})
if(GASJET_COMMIT)
  string(SUBSTRING ${GASJET_COMMIT} 0 12 GASJET_COMMIT)
else()
  execute_process(COMMAND ${git} rev-parse --show-prefix OUTPUT_VARIABLE inside OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE GASJET_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE git_failed)
  if(git_failed OR inside)
    set(GASJET_COMMIT "unknown")
  else()
    # Pages and charts that a build has just written do not change what it is.
    execute_process(COMMAND ${git} diff --quiet HEAD -- . :!docs ERROR_QUIET RESULT_VARIABLE dirty)
    if(dirty)
      string(APPEND GASJET_COMMIT "-dirty")
    endif()
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
