# SPDX-License-Identifier: Apache-2.0
"""Who may include whom: the libraries know nothing of each other, the driver's layers only those below them."""

import os
import re

from tree import CPP, rule

# Each library by its folder: the namespace of its own, and packages it may use beside the standard library.
LIBRARIES = {
    "libgas": ("gas", {"elementary", "boost", "gsl"}),
    "libjet": ("jet", {"elementary", "Eigen", "CGAL", "experimental"}),
    "libmembrane": ("membrane", {"elementary", "Eigen", "experimental"}),
    "libmembrane/mesh": ("mesh", {"elementary", "Eigen"}),
    "libcoupling": ("coupling", {"elementary", "Eigen", "experimental"}),
    "verification/closed_form": ("closed_form", {"gsl"}),
    "verification/enclosure": ("enclosure", {
        "acb.h", "acb_calc.h", "acb_elliptic.h", "acb_hypgeom.h", "acb_modular.h", "arb.h", "arb_hypgeom.h", "arb_mat.h", "arb_poly.h",
        "flint"}),
}
NAMES = "(gas|membrane|mesh|jet|coupling|closed_form|enclosure|driver)"
# CGAL's headers are slow to compile, and some of them are under the GPL.
MAY_USE_CGAL = r"libjet/src/.*\.cpp|driver/results/src/(mesh_files/soup|crossing/exact)\.cpp|(verification|benchmarks)/.*"
# The driver's layers from below; those of one line do not know each other.
LAYERS = ["base"], ["engine"], ["forecast"], ["results"], ["export"], ["import", "compare"], ["report"], ["many_runs"], ["commands"]
HEIGHT = {layer: height for height, row in enumerate(LAYERS) for layer in row}


def includes(tree, paths):
    """(file:line, file, < or ", header) of each include."""
    for place, found in tree.matches(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]*)', paths):
        yield place, place.rsplit(":", 1)[0], found[1], found[2]


def is_allowed(tree, path, quote, header, folder, packages):
    """Its own headers, the standard library (a name without a folder), the compiler's intrinsics and the packages."""
    if quote == '"':
        places = (f"{folder}/include", f"{folder}/src", os.path.dirname(path))
        return ".." not in header and any(tree.exists(f"{place}/{header}") for place in places)
    return re.fullmatch(r"[a-z0-9_]+|[a-z]mmintrin\.h", header) or header.split("/")[0] in packages


def library_of(path):
    return re.sub(r"/(include|src)/.*|/CMakeLists.txt$", "", path)


@rule
def include_rule(tree):
    for place, path, quote, header in includes(tree, tree.files(*CPP)):
        folder = library_of(path)
        if folder in LIBRARIES and not is_allowed(tree, path, quote, header, folder, LIBRARIES[folder][1]):
            yield f"{place}: includes {header}: allowed are {folder}, the standard library, {', '.join(sorted(LIBRARIES[folder][1]))}"
        if header.startswith("CGAL/") and not re.fullmatch(MAY_USE_CGAL, path):
            yield f"{place}: includes {header} (CGAL belongs in .cpp files of libjet/src, in driver/results in soup.cpp and exact.cpp)"
    sources, lists = tree.files(*CPP, under="lib"), tree.files("CMakeLists.txt", under="lib")
    for what, pattern, paths in (("names", rf"\b{NAMES}::", sources), ("links", rf"\b(?:gasjet::|gasjet_|lib){NAMES}\b", lists)):
        for place, found in tree.code_matches(pattern, paths):
            own = LIBRARIES.get(library_of(place.rsplit(":", 1)[0]), ("", ""))[0]
            if own and found[1] != own:
                yield f"{place}: {what} another library: {found[0]}"


@rule
def layers(tree):
    """A file of a driver's layer includes headers of its own layer, and public ones of the layers below."""
    for layer in HEIGHT:
        below = [other for other in HEIGHT if HEIGHT[other] < HEIGHT[layer]]
        for place, path, quote, header in includes(tree, tree.files(*CPP, under=f"driver/{layer}/")):
            beside = os.path.normpath(f"{os.path.dirname(path)}/{header}")
            places = [beside] + [f"driver/{other}/{part}/{header}" for other in (layer, *HEIGHT) for part in ("include", "src")]
            provider = next((name for name in places if quote == '"' and tree.exists(name)), f"driver/{layer}/")
            of, part = (provider.split("/") + ["", ""])[1:3]
            if of in HEIGHT and of != layer and (of not in below or part != "include"):
                yield f"{place}: includes {header} of {of}: allowed are {layer} and public headers of {', '.join(below) or 'no other layer'}"
        for place, found in tree.code_matches(rf"\bgasjet(?:_|::)({'|'.join(HEIGHT)})\b",
                                              tree.files("CMakeLists.txt", under=f"driver/{layer}/")):
            if found[1] != layer and found[1] not in below:
                yield f"{place}: links {found[1]}: allowed are {', '.join(below) or 'no other layer'}"


@rule
def geometry_include(tree):
    """Whoever calls Eigen's geometry includes it: otherwise a file compiles only behind another one, as in a unity build."""
    for path in tree.files(*CPP, under="(?!verification/)"):  # tests have it from the headers that they share
        calls = tree.code_matches(r"(\.|->)(cross|unitOrthogonal)\(|\b(AngleAxisd|Quaterniond)\b", [path])
        if (first := next(calls, None)) and not re.search("<Eigen/(Geometry|Dense)>", tree.read(path)):
            yield f"{first[0]}: calls Eigen's geometry: include <Eigen/Geometry>"
