// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: data compressed by zlib.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mesh {

/// The `size` bytes that a stream of zlib (RFC 1950, 1951) holds, without a value if it is damaged or holds
/// another number of bytes.
std::optional<std::string> inflate(std::string_view stream, std::size_t size);

}  // namespace mesh
