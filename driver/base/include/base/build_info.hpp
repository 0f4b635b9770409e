// SPDX-License-Identifier: Apache-2.0
// What this build was made of. CMake writes the source, build_info.cpp, at every build.
#pragma once

namespace driver::build_info {

extern const char* const version;
extern const char* const commit;
extern const char* const compiler;
extern const char* const flags;

}  // namespace driver::build_info
