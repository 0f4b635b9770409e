# SPDX-License-Identifier: Apache-2.0
# The version of the program and of each library (docs/versions.md).
set(GASJET_VERSION 0.1.0)
