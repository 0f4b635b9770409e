// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.hpp"
#include "driver/case_reader.hpp"

namespace driver::commands {
namespace {

bool is_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;  // of a file that is not there yet: then the names decide
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  return std::filesystem::absolute(a).lexically_normal() == std::filesystem::absolute(b).lexically_normal();
}

}  // namespace

void refuse_same_file(const char* option, const std::filesystem::path& out,
                      std::initializer_list<std::filesystem::path> inputs) {
  for (const auto& input : inputs)
    if (!out.empty() && !input.empty() && is_same(out, input))
      throw CaseError(fmt::format("{} {}: would overwrite {}, another file is allowed", option, out.string(),
                                  input.string()));
}

}  // namespace driver::commands
