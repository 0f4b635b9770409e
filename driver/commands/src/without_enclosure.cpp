// SPDX-License-Identifier: Apache-2.0
// In place of command_enclose.cpp in a build without Arb.
#include "base/case_reader.hpp"
#include "commands/command.hpp"

namespace driver::commands {

int enclose(const EncloseArguments&) {
  throw CaseError(
      "enclose: this build has no ball arithmetic: install Arb (Debian: libflint-arb-dev), then configure "
      "and build "
      "again");
}

}  // namespace driver::commands
