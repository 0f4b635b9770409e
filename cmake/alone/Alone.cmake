# SPDX-License-Identifier: Apache-2.0
# Packages without shared libraries and threads: headers of Debian's packages alone, and where headers are not enough one source here.
# A program made so needs nothing of its machine, so that it runs in a browser (preset `browser`); preset `alone` makes the same program
# for this machine. The presets name this file in CMAKE_PROJECT_TOP_LEVEL_INCLUDES; find_package then asks it first.
set(GASJET_ALONE ON CACHE BOOL "One thread, no shared libraries: see cmake/alone/README.md" FORCE)

# Links to the headers: /usr/include as a whole would hide those of emscripten.
set(GASJET_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${GASJET_HEADERS})
foreach(name boost CGAL fmt nlohmann toml++ CLI)
  file(CREATE_LINK /usr/include/${name} ${GASJET_HEADERS}/${name} SYMBOLIC)
endforeach()
file(CREATE_LINK /usr/include/eigen3/Eigen ${GASJET_HEADERS}/Eigen SYMBOLIC)
if(CMAKE_SYSTEM_NAME STREQUAL "Emscripten" OR CMAKE_TOOLCHAIN_FILE MATCHES "Emscripten")
  set(GASJET_GSL ${CMAKE_BINARY_DIR}/gsl/libgsl.a)
  if(NOT EXISTS ${GASJET_GSL})
    message(FATAL_ERROR "${GASJET_GSL}: is not there; scripts/setup_browser.py makes it")
  endif()
  file(CREATE_LINK ${CMAKE_BINARY_DIR}/gsl/include/gsl ${GASJET_HEADERS}/gsl SYMBOLIC)
else()
  set(GASJET_GSL gsl gslcblas)
endif()

# What a step calls, but for the kernels, is compiled by these options, and closed forms. emcc's own -Oz inlines nothing: with Eigen's and the library's small functions as
# calls the program is as large, and a run of the paper's scene takes 1.7 times as long.
set(GASJET_SMALL -Oz)

# Calls of C++'s own exceptions, vectors of 16 bytes, and instructions that copy memory; libc++ 13 lacks a part of C++20. clang 14's SLP
# vectoriser writes one part of v = A v before it has read it: free_headform went wrong by it (coupling::detail::Placed::depth).
if(GASJET_GSL MATCHES "libgsl.a")
  list(APPEND GASJET_SMALL -finline-functions "SHELL:-mllvm -inline-threshold=25")
  add_compile_options(-fno-pic -fwasm-exceptions -msimd128 -mbulk-memory -fno-slp-vectorize "SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/old_libcxx.hpp")
  add_link_options(-fwasm-exceptions)
endif()

# gasjet_headers(TARGET): a package that is headers alone.
function(gasjet_headers target)
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE ${GASJET_HEADERS})
  endif()
endfunction()

macro(gasjet_provide_package method package)
  if(${package} STREQUAL Boost)
    gasjet_headers(Boost::headers)
  elseif(${package} STREQUAL Eigen3)
    gasjet_headers(Eigen3::Eigen)
  elseif(${package} STREQUAL nlohmann_json)
    gasjet_headers(nlohmann_json::nlohmann_json)
  elseif(${package} STREQUAL CLI11)
    gasjet_headers(CLI11::CLI11)
  elseif(${package} STREQUAL fmt)
    gasjet_headers(fmt::fmt)
    target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
  elseif(${package} STREQUAL CGAL)
    # Exact numbers by Boost.Multiprecision; intervals are widened, because WebAssembly rounds to nearest alone.
    gasjet_headers(CGAL::CGAL)
    target_compile_definitions(CGAL::CGAL INTERFACE CGAL_DISABLE_GMP CGAL_ALWAYS_ROUND_TO_NEAREST)
  elseif(${package} STREQUAL tomlplusplus)
    gasjet_headers(tomlplusplus::tomlplusplus)
    if(NOT TARGET gasjet_toml)
      add_library(gasjet_toml STATIC ${CMAKE_SOURCE_DIR}/cmake/alone/toml.cpp)
      target_compile_features(gasjet_toml PRIVATE cxx_std_20)
      target_compile_options(gasjet_toml PRIVATE -w ${GASJET_SMALL})
      target_include_directories(gasjet_toml SYSTEM PRIVATE ${GASJET_HEADERS})
      target_link_libraries(tomlplusplus::tomlplusplus INTERFACE gasjet_toml)
    endif()
  elseif(${package} STREQUAL GSL)
    gasjet_headers(GSL::gsl)
    gasjet_headers(GSL::gslcblas)
    set_property(TARGET GSL::gsl PROPERTY INTERFACE_LINK_LIBRARIES ${GASJET_GSL})
  elseif(${package} STREQUAL TBB) # driver/base/src/executor_alone.cpp in its place
    gasjet_headers(TBB::tbb)
  elseif(${package} STREQUAL ZLIB) # driver/report/src/deflate_alone.cpp in its place
    gasjet_headers(ZLIB::ZLIB)
  endif()
  set(${package}_FOUND TRUE)
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER gasjet_provide_package SUPPORTED_METHODS FIND_PACKAGE)
