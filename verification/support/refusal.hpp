// SPDX-License-Identifier: Apache-2.0
// What a call refuses.
#pragma once
#include <functional>
#include <stdexcept>
#include <string>

/// Message of the std::invalid_argument that the call throws; "accepted" without one.
inline std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}
