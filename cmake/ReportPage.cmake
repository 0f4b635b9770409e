# SPDX-License-Identifier: Apache-2.0
# Takes the page of `gasjet report`, with three.js of the system, into gasjet_report. Without three.js (Debian: libjs-three) the page has no
# pictures in three dimensions, and says so.
find_file(GASJET_THREE three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build NO_DEFAULT_PATH)
find_file(GASJET_ORBIT OrbitControls.js PATHS /usr/share/javascript/three/examples/js/controls NO_DEFAULT_PATH)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.js "")
if(GASJET_THREE AND GASJET_ORBIT)
  set(GASJET_THREE_FILE ${GASJET_THREE})
  set(GASJET_ORBIT_FILE ${GASJET_ORBIT})
else()
  message(STATUS "three.js not found (Debian: libjs-three): gasjet report without pictures in three dimensions")
  set(GASJET_THREE_FILE ${CMAKE_CURRENT_BINARY_DIR}/empty.js)
  set(GASJET_ORBIT_FILE ${CMAKE_CURRENT_BINARY_DIR}/empty.js)
endif()
set(GASJET_PAGE ${CMAKE_CURRENT_SOURCE_DIR}/src/page)
configure_file(src/page_parts.cpp.in page_parts.cpp @ONLY)
file(GLOB page_files CONFIGURE_DEPENDS ${GASJET_PAGE}/*)
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
  OBJECT_DEPENDS "${page_files};${GASJET_THREE_FILE};${GASJET_ORBIT_FILE}")
target_sources(gasjet_report PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp)
