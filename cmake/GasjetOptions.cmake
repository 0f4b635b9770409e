# SPDX-License-Identifier: Apache-2.0
# Compiler options shared by every Gasjet target; included by each library, so that each builds alone.
include_guard(GLOBAL)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
# In a project that takes Gasjet by FetchContent, its libraries are not among what that project installs.
set(is_own OFF)
if(CMAKE_PROJECT_NAME MATCHES "^gasjet")
  set(is_own ON)
endif()
option(GASJET_INSTALL "Install Gasjet's libraries with the project" ${is_own})
option(GASJET_WERROR "Treat compiler warnings as errors" OFF)
option(GASJET_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(GASJET_SANITIZE_THREADS "Build with ThreadSanitizer, see scripts/tests/threads.sh" OFF)
option(GASJET_FUZZ "Build the harnesses of libFuzzer (clang), see scripts/tests/fuzz.sh" OFF)

# Headers are two thirds of the work for most files: ten sources are compiled as one. With ccache each by itself, so
# that an edit costs one. -DCMAKE_UNITY_BUILD=ON or OFF decides otherwise.
if(NOT DEFINED CMAKE_UNITY_BUILD AND NOT CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_UNITY_BUILD ON)
endif()

add_library(gasjet_options INTERFACE)
target_compile_features(gasjet_options INTERFACE cxx_std_20)
# Headers alone, for sources: what is installed does not need them.
target_include_directories(gasjet_options INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../elementary/include)
# Bitwise reproducibility: no contraction, no -ffast-math. The two -fno flags change no value.
target_compile_options(gasjet_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  # For clang a local name hides one of another file's unnamed namespace that is compiled with it.
  $<$<AND:$<CXX_COMPILER_ID:Clang>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-shadow>
  # gcc 12 warns of sums of texts that begin with a literal, wrongly (its bug 105651), where files are compiled alone.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>>:-Wno-restrict>
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  # Eigen's sums have one order on every processor. The layout of its types stays that of its default.
  -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16
  # gcc collects no garbage below a gigabyte: a tenth of the compile time, the same code.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>
  $<$<BOOL:${GASJET_WERROR}>:-Werror>
  $<$<BOOL:${GASJET_SANITIZE}>:-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer>
  # What these three see AddressSanitizer stops at too, but for alignment; they take a third of the build.
  $<$<BOOL:${GASJET_SANITIZE}>:-fno-sanitize=null,alignment,object-size>
  $<$<BOOL:${GASJET_SANITIZE_THREADS}>:-fsanitize=thread>
  $<$<BOOL:${GASJET_FUZZ}>:-fsanitize=fuzzer-no-link>
  # Eigen's temporaries go out of scope so often that to watch for it takes up to four fifths of a test's time.
  $<$<BOOL:${GASJET_SANITIZE}>:-fno-sanitize-address-use-after-scope>)
# Eigen aligns by hand where it sees AddressSanitizer; the tests' objects, compiled without, must free the same way.
target_compile_definitions(gasjet_options INTERFACE $<$<BOOL:${GASJET_SANITIZE}>:EIGEN_MALLOC_ALREADY_ALIGNED=1>)
target_link_options(gasjet_options INTERFACE
  # Its megabytes of addresses need not be filled in at each start of a program that loads at a fixed place.
  $<$<AND:$<BOOL:${GASJET_SANITIZE}>,$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>>:-no-pie>
  $<$<BOOL:${GASJET_SANITIZE}>:-fsanitize=address,undefined>
  $<$<BOOL:${GASJET_SANITIZE_THREADS}>:-fsanitize=thread>)

# Thirty compile in two thirds of the time, but the compiler then inlines less: a run takes 2 to 3 % longer.
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 10)
endif()
