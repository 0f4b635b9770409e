#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes docs/stability.md from the rows that the tests of thresholds write.
# usage: scripts/stability_atlas.sh [--from ROWS | --check [ROWS [PAGE]]]
#   --from   take the rows that are in the folder ROWS already, instead of running the tests
#   --check  compare docs/stability.md (or PAGE) with rows already in the folder ROWS (build/claims);
#            exit code 1 if they differ
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=claim_page.sh
source scripts/claim_page.sh

page_head() {
  cat <<'HEAD'
# Stability atlas

How each method fails, where by its formula, where as measured, and what the program does there. Written by
`scripts/stability_atlas.sh` from the tests' own assertions: each row is one, with the numbers that it saw.
*Predicted* is the formula's value; *measured* comes from running the method itself, by bisection on the step
(or on what else decides) between runs that stay bounded and runs that do not; the ratio has to lie in the
band *allowed*. 〃 repeats the text above. The links lead to the section of the theory that defines the
equation, and to the test.

Rows that say *bound* have the program's own bound as predicted. The bound of a bag (M.15) stands against the
limit that power iteration gives, not runs; those of contact (K.12) and of the jet from rest
(J.9) against runs, the latter up to the step after which the skin outruns the jet and its load goes out.
Power iteration is also what the passenger bag's bisected step is held against. The frequency of the gas
(M.11), (M.20) and of the flickering mode (J.10) is that of the program's own forces.

Some failures have no threshold, since they happen at any step: a pressure that lags, fabric that bears
compression, work taken with the pressure of the step's start. Their rows give the rate, and measured is the
rate seen.

Limits of the explicit gas steppers hold for fixed sub-steps; with error control the sub-step follows, at a
cost that [work against precision](charts/gas_work_precision.svg) shows. Limits of the bag hold for a fixed
step (`time.step`), which is refused above its bound unless `time.unsafe_step` says otherwise; without one the
step follows the bound.

CI compares this page with what its own tests wrote (`scripts/stability_atlas.sh --check`): a row that
appeared or vanished, another text or band, a predicted value that moved by more than 0.1 % or a ratio by more
than 0.5 % is a failure.

## Maps

Each point is a run of a bag of 80 elements, of 400 steps in the first two maps; the line is the formula.
`scripts/stability_maps.sh` writes them.

There is no map of the contact's stiffness against the step: it adds to the bag's frequency as the gas does
(M.12), but a ball touches few points of a node: what happens past that formula is in rows below.

**One sliver sets the step of the whole bag.** One node of the sphere is moved along a side
([table](charts/stability_sliver.csv)): no run below the bound blows up, and few above it do not.

![Stable and blown-up runs over the shortest side and the time step, and the bound](charts/stability_sliver.svg)

**Gas takes over as the volume falls.** The same sphere, slack, flattened, with air at rest inside
([table](charts/stability_gas.csv)): the limit goes as the root of the volume; full, the fabric sets it, and
slack fabric allows more than its bound.

![Stable and blown-up runs over the volume and the time step, and the bound](charts/stability_gas.svg)

**A pressure that lags by one step blows up at every step, if one waits.** The sphere flattened to a tenth,
every step below the step bound ([table](charts/stability_lagged.csv)): halving the step only doubles the time
until a disturbance has grown 100 000-fold.

![Stable and blown-up runs over the time simulated and the time step, and the growth's formula](charts/stability_lagged.svg)

HEAD
}

claim_page stability_atlas stability_drift docs/stability.md "$@"
