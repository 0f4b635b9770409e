// SPDX-License-Identifier: Apache-2.0
#include <gasjet/base.h>

#include "border.hpp"

const gasjet_handle border::kHandlesBegin = 0;

const char* gasjet_version() {
  return GASJET_VERSION;
}

const char* gasjet_last_error() {
  return border::last_error();
}

int gasjet_free(gasjet_handle handle) {
  return border::call([&] { border::release(handle); });
}
