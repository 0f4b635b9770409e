// SPDX-License-Identifier: Apache-2.0
#include "base/share.hpp"

#include <fmt/format.h>

#include "base/case_reader.hpp"

namespace driver {

std::string Share::name() const {
  return fmt::format("{}_of_{}", number, count);
}

Share share_of(const std::string& text) {
  Share share;
  if (text.empty()) return share;
  const auto slash = text.find('/');
  const auto number = [](const std::string& part) {
    return !part.empty() && part.size() < 7 && part.find_first_not_of("0123456789") == std::string::npos
               ? std::stoi(part)
               : 0;
  };
  if (slash != std::string::npos) share = {number(text.substr(0, slash)), number(text.substr(slash + 1))};
  if (slash == std::string::npos || share.number < 1 || share.number > share.count)
    throw CaseError(fmt::format("--share {}: NUMBER/COUNT with 1 <= NUMBER <= COUNT is allowed", text));
  return share;
}

}  // namespace driver
