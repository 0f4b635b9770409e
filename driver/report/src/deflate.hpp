// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace driver {

/// The bytes in the format of zlib (RFC 1950), for the page's DecompressionStream. Throws std::bad_alloc. A
/// program without zlib stores them as they are, in that format too.
std::string deflated(const std::string& bytes);

}  // namespace driver
