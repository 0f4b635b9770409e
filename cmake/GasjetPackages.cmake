# SPDX-License-Identifier: Apache-2.0
# What a user takes, and the Debian packages of it: `cpack -G DEB` in the build folder writes packages/*.deb, one for each component
# of the installation that this build has.
set(data ${CMAKE_INSTALL_DATADIR}/gasjet)
install(DIRECTORY cases DESTINATION ${data} COMPONENT command)
install(PROGRAMS verification/run_external.py DESTINATION ${data} COMPONENT command)
install(DIRECTORY verification/schemas DESTINATION ${data} COMPONENT command)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gasjet COMPONENT docs)
install(DIRECTORY ${PROJECT_BINARY_DIR}/site/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gasjet/site COMPONENT docs OPTIONAL) # scripts/docs_site.sh

get_cmake_property(components COMPONENTS)
if("Unspecified" IN_LIST components)
  message(FATAL_ERROR "An install() without COMPONENT: what it installs would be in no package")
endif()

# gasjet_package(COMPONENT NAME SUMMARY SECTION of Debian [LICENCE of its binary] [DEPENDS Debian's packages, beside those of its
#   shared libraries] [ANY_MACHINE]): the package of a component, if this build has it.
function(gasjet_package component name summary)
  cmake_parse_arguments(ARG "ANY_MACHINE" "LICENCE;DEPENDS;SECTION" "" ${ARGN})
  if(NOT component IN_LIST components)
    return()
  endif()
  set(licence_of_binary "What a binary falls under that links a library of Gasjet is in README.md, Layout.")
  if(ARG_LICENCE)
    set(licence_of_binary "The binary as a whole falls under ${ARG_LICENCE}, that of libraries which it links.")
  endif()
  configure_file(cmake/packaging/copyright.in ${PROJECT_BINARY_DIR}/packaging/${name}/copyright @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/packaging/${name}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} key)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${summary}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${ARG_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${ARG_DEPENDS}" PARENT_SCOPE)
  if(ARG_ANY_MACHINE)
    set(CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE all PARENT_SCOPE)
  else()
    set(CPACK_DEBIAN_${key}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
  endif()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
endfunction()

set(CPACK_COMPONENTS_ALL)
set(same "(= ${PROJECT_VERSION})")
gasjet_package(command gasjet "Command, cases, reference histories" SECTION science LICENCE "GPL-3.0 or later" DEPENDS python3)
gasjet_package(development libgasjet-dev "Libraries and headers for C++, with packages for CMake" SECTION libdevel
  DEPENDS "libeigen3-dev, libcgal-dev, libgsl-dev")
gasjet_package(c libgasjet "Shared library and header for C" SECTION libs LICENCE "LGPL-3.0 or later")
gasjet_package(exact libgasjet-exact "Closed forms for C and Fortran" SECTION libs LICENCE "GPL-3.0 or later" DEPENDS "libgasjet ${same}")
gasjet_package(fortran libgasjet-fortran "Module and library for Fortran" SECTION libdevel DEPENDS "libgasjet ${same}")
gasjet_package(python python3-gasjet "Module gasjet for Python" SECTION python LICENCE "LGPL-3.0 or later" DEPENDS "libgasjet ${same}, ${GASJET_PYTHON_DEPENDS}, python3-numpy")
gasjet_package(python_exact python3-gasjet-exact "Closed forms for Python" SECTION python LICENCE "GPL-3.0 or later"
  DEPENDS "python3-gasjet ${same}, libgasjet-exact ${same}")
gasjet_package(docs gasjet-doc "Documentation" SECTION doc ANY_MACHINE)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gasjet)
set(CPACK_PACKAGE_VENDOR "The Gasjet authors")
set(CPACK_PACKAGE_CONTACT "The Gasjet authors <authors@gasjet.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Inflates airbags with an analytical gas jet")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/bindings/c) # libraries of our own, by DEPENDS
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
