// SPDX-License-Identifier: Apache-2.0
#include "import_options.hpp"

#include "validators.hpp"

namespace driver::commands {

void add_import(CLI::App& app, ImportArguments& a) {
  auto* c = app.add_subcommand("import", "write the bag in another program's deck as a case");
  c->add_option("deck", a.deck, "LS-DYNA keyword deck (.k, .key, .dyn) or Radioss starter deck (.rad)")
      ->required()
      ->check(named);
  c->add_option("--out", a.out, "folder of the case, with import.md and import.json")
      ->required()
      ->check(named);
  c->add_option("--bag", a.bag, "number of the airbag or monitored volume, if the deck has several");
  c->add_flag("--merge-chambers", a.merge_chambers,
              "make one chamber of all monitored volumes of a Radioss deck");
  c->add_option("--units", a.units, "mass-length-time of a deck that does not state them, such as kg-mm-ms")
      ->check(named);
}

}  // namespace driver::commands
