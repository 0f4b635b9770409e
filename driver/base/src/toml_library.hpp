// SPDX-License-Identifier: Apache-2.0
// toml++ as this library uses it: compiled once, in its own shared library.
#pragma once

#define TOML_HEADER_ONLY 0
#ifndef TOML_ENABLE_FORMATTERS
#define TOML_ENABLE_FORMATTERS 0  // only needed where a case is written
#endif
#include <toml++/toml.h>
