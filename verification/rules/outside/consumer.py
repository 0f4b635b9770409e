# SPDX-License-Identifier: Apache-2.0
"""The parts of the package from where it is installed: a tank beside its closed form, hidden elements, a case of one's own."""
import sys

import numpy as np

import gasjet

nodes = np.vstack([np.zeros(3), np.eye(3)])
lit = gasjet.visible(nodes, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], centre=(0.1, 0.1, 0.1), axis=(1, 0, 0))
tank = gasjet.Tank(gasjet.Gas.ideal(296.8, 1038.8), 5e5, 600.0, 0.06)
tank.add_vent(1e-3)
pressure = tank.advance(0.1)["pressure_Pa"]
if "--without-exact" in sys.argv:
    try:
        gasjet.exact("blowdown")
    except ImportError as error:
        sys.exit(0 if "python3-gasjet-exact" in str(error) else 1)
    sys.exit("Python: closed forms without their package")
off = abs(pressure / gasjet.exact("blowdown", times=[0.1])["pressure_Pa"][0] - 1.0)
holds = bool(lit.all()) and off < 1e-8 and gasjet.__version__ != ""
print(f"Python: off by {off:.0e}: {'holds' if holds else 'differs'}")
sys.exit(0 if holds else 1)
