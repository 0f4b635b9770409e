// SPDX-License-Identifier: Apache-2.0
// In place of command_export.cpp and command_import.cpp in a program that is to be small (cmake/alone).
#include "base/case_reader.hpp"
#include "commands/command.hpp"

namespace driver::commands {
namespace {

[[noreturn]] void refuse(const char* command) {
  throw CaseError(std::string(command) + ": this program has no decks: use one of preset release");
}

}  // namespace

int export_deck(const ExportArguments&) {
  refuse("export");
}

int import_deck(const ImportArguments&) {
  refuse("import");
}

}  // namespace driver::commands
