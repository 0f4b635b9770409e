// SPDX-License-Identifier: Apache-2.0
#include "deflate.hpp"

#include <zlib.h>

#include <new>

namespace driver {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
               bytes.size()) != Z_OK)
    throw std::bad_alloc();  // the only possible failure with a buffer of that size
  packed.resize(size);
  return packed;
}

}  // namespace driver
