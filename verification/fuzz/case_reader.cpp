// SPDX-License-Identifier: Apache-2.0
// Any bytes are a case, or are refused with a message: no crash, no hang.
#include "base/case_reader.hpp"

#include "bytes.hpp"
#include "results/load_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    driver::CaseDocument document(fuzz::file_of(data, size, ".toml"), {});
    driver::load_scene(document);
  } catch (const driver::CaseError& error) {
    fuzz::require(error.what()[0] != '\0', "a refusal says why");
  }
  return 0;
}
