// SPDX-License-Identifier: Apache-2.0
// The first members of every JSON output for other programs.
#pragma once

#include <nlohmann/json.hpp>

#include "base/build_info.hpp"
#include "base/formats.hpp"

namespace driver {

/// Version of the format, version and commit of the program.
template <class Json>
Json json_head() {
  return {{"format", formats::json}, {"version", build_info::version}, {"commit", build_info::commit}};
}

}  // namespace driver
