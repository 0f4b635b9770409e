// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace driver::commands {

/// Adds the command; its option is read into `folder`.
void add_manual(CLI::App& app, std::filesystem::path& folder);
/// Writes the man pages of `app` and of each of its commands to `folder`/man/man1, and its bash completion to
/// `folder`/bash-completion/completions: all from the program's own commands and options. Throws OutputError
/// for a folder or file that cannot be written.
void write_manual(const CLI::App& app, const std::filesystem::path& folder);

}  // namespace driver::commands
