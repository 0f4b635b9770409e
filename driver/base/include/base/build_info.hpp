// SPDX-License-Identifier: Apache-2.0
// Version, commit, compiler and flags of this build. CMake writes the source, build_info.cpp, at every build.
#pragma once

namespace driver::build_info {

extern const char* const version;
extern const char* const commit;
extern const char* const compiler;
extern const char* const flags;

}  // namespace driver::build_info
