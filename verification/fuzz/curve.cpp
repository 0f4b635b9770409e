// SPDX-License-Identifier: Apache-2.0
// Any bytes are the CSV file of a case's curve, or are refused at their place.
#include "base/curve_reader.hpp"
#include "bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::file_of(data, size, ".csv");
  const std::string text = "flow = { file = \"" + file.filename().string() + "\", column = \"a\" }\n";
  const auto toml = file.parent_path() / "curve.toml";
  std::ofstream(toml) << text;
  try {
    driver::CaseDocument document(toml, {});
    driver::TableReader root = document.root();
    const driver::CurveData curve = driver::CurveReader(root, "flow").curve(driver::any_number);
    fuzz::require(curve.time.size() == curve.value.size(), "a value for each time");
    for (std::size_t i = 1; i < curve.time.size(); ++i)
      fuzz::require(curve.time[i] >= curve.time[i - 1], "times do not fall");
  } catch (const driver::CaseError& error) {
    fuzz::require(error.what()[0] != '\0', "a refusal says why");
  }
  return 0;
}
