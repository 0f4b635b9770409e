#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes docs/stability.md from the rows that the tests of thresholds write.
# usage: docs/make/pages/stability_atlas.sh [--from ROWS | --check [ROWS [PAGE]]]
#   --from   take the rows that are in the folder ROWS already, instead of running the tests
#   --check  compare docs/stability.md (or PAGE) with rows already in the folder ROWS (build/claims);
#            exit code 1 if they differ
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source-path=SCRIPTDIR source=claim_page.sh
source docs/make/pages/claim_page.sh

page_head() {
  cat <<'HEAD'
# Stability atlas

Each row is a way in which a method fails: the limit by its formula, the limit as measured, and what
the program does past it. `docs/make/pages/stability_atlas.sh` writes the page from the tests' own
assertions, with the numbers that they saw.

- *Predicted* is the formula's value.
- *Measured* comes from running the method itself: bisection on the step, or on what else decides,
  between runs that stay bounded and runs that do not.
- The *ratio* of the two has to lie in the band *allowed*.
- 〃 repeats the text above. The links lead to the section of the theory that defines the equation,
  and to the test.

**Rows that say *bound*** have the program's own bound as predicted. The bound of a bag (M.15) is
compared with the limit that power iteration gives, not with runs. So is the passenger bag's
bisected step. The bounds of contact (K.12) and of the jet from rest (J.9) are compared with runs.
Those of the jet end at the step after which the skin outruns the jet and its load goes out. The
frequencies of the gas (M.11), (M.20) and of the flickering mode (J.10) are those of the program's
own forces.

**Failures without a threshold** happen at any step: a pressure that lags, fabric that bears
compression, work taken with the pressure of the step's start. Their rows give the rate; measured is
the rate seen.

**Fixed steps.** Limits of the explicit gas steppers hold for fixed sub-steps. With error control
the sub-step follows the limit, at a cost that [work against
precision](charts/gas_work_precision.svg) shows. Limits of the bag hold for a fixed step
(`time.step`). Such a step above its bound is refused unless `time.unsafe_step` allows it. Without a
fixed step, the step follows the bound.

**Check.** CI compares this page with what its own tests wrote (`docs/make/pages/stability_atlas.sh
--check`). It fails if a row appeared or vanished, a text or band changed, a predicted value moved
by more than 0.1 %, or a ratio by more than 0.5 %.

## Maps

Each point is a run of a bag of 80 elements, of 400 steps in the first two maps. The line is the
formula. `scripts/charts.sh stability` writes the maps.

**One sliver sets the step of the whole bag.** One node of the sphere is moved along a side
([table](charts/stability_sliver.csv)). No run below the bound blows up, and few above it do not.

![Stable and blown-up runs over the shortest side and the time step, and the bound](charts/stability_sliver.svg)

**Gas takes over as the volume falls.** The same sphere is slack and flattened, with air at rest
inside ([table](charts/stability_gas.csv)). The limit goes as the root of the volume. In the full
sphere the fabric sets it, and slack fabric allows more than its bound.

![Stable and blown-up runs over the volume and the time step, and the bound](charts/stability_gas.svg)

**A pressure that lags by one step blows up at every step, if one waits.** The sphere is flattened
to a tenth, and every step is below the step bound ([table](charts/stability_lagged.csv)). Halving
the step only doubles the time until a disturbance has grown 100 000-fold.

![Stable and blown-up runs over the time simulated and the time step, and the growth's formula](charts/stability_lagged.svg)

There is no map of the contact's stiffness against the step. It adds to the bag's frequency as the
gas does (M.12), but a ball touches few points of a node. Rows below show what happens past that
formula.

HEAD
}

claim_page stability_atlas docs/stability.md "$@"
