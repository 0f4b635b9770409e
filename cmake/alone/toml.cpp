// SPDX-License-Identifier: Apache-2.0
// toml++ itself, which Debian has as a shared library.
#define TOML_HEADER_ONLY 0
#define TOML_IMPLEMENTATION 1
#include <toml++/toml.h>
