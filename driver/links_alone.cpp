// SPDX-License-Identifier: Apache-2.0
// A program of one layer: it links if the layer needs nothing from above.
int main() {}
