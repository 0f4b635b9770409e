// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gas {

extern const char* const kNasa7Csv;  // text of data/nasa7.csv

}  // namespace gas
