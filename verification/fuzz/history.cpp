// SPDX-License-Identifier: Apache-2.0
// Any bytes are a history, or are refused with a message; one that is read compares with itself, and differs
// by nothing.
#include "base/case_reader.hpp"
#include "bytes.hpp"
#include "compare/compare.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const driver::History history = driver::read_history(fuzz::file_of(data, size, ".csv"));
    for (const auto& quantity : driver::compare(history, history).quantities)
      for (std::size_t i = 0; i < quantity.values.size(); ++i)
        fuzz::require(quantity.values[i] == quantity.expected[i], "a history is itself");
  } catch (const driver::CaseError& error) {
    fuzz::require(error.what()[0] != '\0', "a refusal says why");
  }
  return 0;
}
