# SPDX-License-Identifier: Apache-2.0
# Meshes of the reference scenes as OBJ. usage: awk -v shape=disc|baffle -v cells=N -f reference_meshes.awk
# disc: radius 0.3 in z = 0, N rings, over a cone with its apex 3 m below. baffle: box of 1 x 1.2 x 1.2 m with N cells a
# metre (a multiple of 10), less a slab from the floor up to z = 0 one cell thick at x = 0.5. Normals point outwards.

function vertex(x, y, z,   key) {
  key = sprintf("%.9g %.9g %.9g", x, y, z)
  if (!(key in index_of)) { index_of[key] = ++vertices; print "v " key }
  return index_of[key]
}
function ring_vertex(k, i) {
  i %= 6 * k
  return vertex(0.3 * k / cells * cos(turn * i / (6 * k)), 0.3 * k / cells * sin(turn * i / (6 * k)), 0)
}
function disc(   k, s, j, i, o, faces, n) {
  for (k = 1; k <= cells; k++)
    for (s = 0; s < 6; s++)
      for (j = 0; j < k; j++) {
        i = k == 1 ? vertex(0, 0, 0) : ring_vertex(k - 1, s * (k - 1) + j)
        faces[n++] = i " " ring_vertex(k, s * k + j) " " ring_vertex(k, s * k + j + 1)
        if (j < k - 1) faces[n++] = i " " ring_vertex(k, s * k + j + 1) " " ring_vertex(k - 1, s * (k - 1) + j + 1)
      }
  for (i = 0; i < 6 * cells; i++)
    cone[i] = vertex(0, 0, -3) " " ring_vertex(cells, i + 1) " " ring_vertex(cells, i)
  print "g membrane"
  for (k = 0; k < n; k++) print "f " faces[k]
  print "g cone"
  for (i = 0; i < 6 * cells; i++) print "f " cone[i]
}
# A cell of the box holds gas, unless it is outside or in the slab.
function gas(i, j, k) {
  if (i < 0 || j < 0 || k < 0 || i >= cells || j >= width || k >= width) return 0
  return !(i == cells / 2 && k < width / 2)
}
function corner(i, j, k) { return vertex(i / cells, (j - width / 2) / cells, (k - width / 2) / cells) }
# Face of cell (i, j, k) towards (a, b, c): the corners in the order whose normal points that way, cut by a diagonal.
function face(i, j, k, a, b, c,   p, q, r, s, x, y, z) {
  x = i + (a > 0); y = j + (b > 0); z = k + (c > 0)
  if (a) { p = corner(x, y, z); q = corner(x, y + 1, z); r = corner(x, y + 1, z + 1); s = corner(x, y, z + 1) }
  if (b) { p = corner(x, y, z); q = corner(x, y, z + 1); r = corner(x + 1, y, z + 1); s = corner(x + 1, y, z) }
  if (c) { p = corner(x, y, z); q = corner(x + 1, y, z); r = corner(x + 1, y + 1, z); s = corner(x, y + 1, z) }
  if (a + b + c < 0) { x = q; q = s; s = x }
  list[count++] = p " " q " " r
  list[count++] = p " " r " " s
}
function baffle(   i, j, k, d) {
  width = 1.2 * cells
  for (i = 0; i < cells; i++)
    for (j = 0; j < width; j++)
      for (k = 0; k < width; k++) {
        if (!gas(i, j, k)) continue
        for (d = -1; d <= 1; d += 2) {
          if (!gas(i + d, j, k)) face(i, j, k, d, 0, 0)
          if (!gas(i, j + d, k)) face(i, j, k, 0, d, 0)
          if (!gas(i, j, k + d)) face(i, j, k, 0, 0, d)
        }
      }
  print "g box"
  for (i = 0; i < count; i++) print "f " list[i]
}
BEGIN {
  turn = 8 * atan2(1, 1)
  print "# " shape ", cells = " cells ", by scripts/reference_meshes.awk"
  if (shape == "disc") disc(); else baffle()
}
