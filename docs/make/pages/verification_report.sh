#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes docs/verification.md from the rows that the tests write.
# usage: docs/make/pages/verification_report.sh [--from ROWS | --check [ROWS [PAGE]]]
#   --from   take the rows that are in the folder ROWS already, instead of running the tests
#   --check  compare docs/verification.md (or PAGE) with rows already in the folder ROWS (build/claims);
#            exit code 1 if they differ
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source-path=SCRIPTDIR source=claim_page.sh
source docs/make/pages/claim_page.sh

page_head() {
  cat <<'HEAD'
# Verification report

Each row is a check that the test named last makes, with the numbers that it saw.
`docs/make/pages/verification_report.sh` writes the page from the tests' own assertions.

- A row of several `checks` (a sweep over parameters, times or elements) shows the one that used
  most of what is allowed.
- Error and allowance are shares of the exact value. `abs.` marks those in the quantity's own unit,
  where that value is zero or smaller than the allowance.
- Errors of an order are those of successive levels, each twice as fine as the one before unless the
  row says otherwise. The orders lie inside the band on both sides.
- The links lead to the section of the theory that defines the equation, and to the test.

Closed forms are those of [`verification/closed_form`](../verification/closed_form/README.md), which
sees none of the libraries.

CI compares this page with what its own tests wrote (`docs/make/pages/verification_report.sh
--check`). It fails if a row appeared or vanished, or if one of these moved: the exact value (by
more than 1e-6 of it), the allowance (2 %), the number of checks, an error (by more than a tenth of
its allowance), or an order (by more than 0.05). Errors of the size of rounding (an allowance below
1e-9) may differ between machines: they only have to stay inside it.

HEAD
}

claim_page verification_report docs/verification.md "$@"
