// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case_reader.hpp"

namespace driver {

struct CaseLog {
  std::filesystem::path folder;   // of the case file; files it names stand beside it
  std::vector<Setting> settings;  // in the order of reading
};

}  // namespace driver
