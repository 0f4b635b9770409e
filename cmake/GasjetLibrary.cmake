# SPDX-License-Identifier: Apache-2.0
# gasjet_library(NAME SOURCES ... [PUBLIC_LINK ...] [PRIVATE_LINK ...] [PACKAGES ...])
# One independent library: target gasjet_NAME, alias gasjet::NAME, package gasjet_NAME (find_package), headers include/NAME.
# PACKAGES are the packages a user of the installed library needs.
include_guard(GLOBAL)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(${CMAKE_CURRENT_LIST_DIR}/GasjetOptions.cmake)

function(gasjet_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC_LINK;PRIVATE_LINK;PACKAGES" ${ARGN})
  set(target gasjet_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(gasjet::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC_LINK} PRIVATE ${ARG_PRIVATE_LINK} $<BUILD_INTERFACE:gasjet_options>)

  if(NOT GASJET_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT ${target}-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/${target})
  install(EXPORT ${target}-targets NAMESPACE gasjet:: DESTINATION ${package_dir} COMPONENT development)
  set(config "include(CMakeFindDependencyMacro)\n")
  foreach(package IN LISTS ARG_PACKAGES)
    string(APPEND config "find_dependency(${package})\n")
  endforeach()
  string(APPEND config "include(\${CMAKE_CURRENT_LIST_DIR}/${target}-targets.cmake)\n")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${target}-config.cmake "${config}")
  write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/${target}-config-version.cmake
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/${target}-config-version.cmake DESTINATION ${package_dir} COMPONENT development)
endfunction()
