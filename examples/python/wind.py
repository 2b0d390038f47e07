# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The quickest course through a current that is two arrays: an eddy that turns to the left, row 0 in the north."""
import leastcost as lc
import matplotlib.pyplot as plt
import numpy as np

y, x = np.mgrid[3.95:-4:-0.1, -4.95:5:0.1]  # middles of cells
eddy = 0.8 * np.exp(-(x**2 + y**2) / 4)
current = lc.Wind(-y * eddy, x * eddy, speed=1, origin=(-5, -4), cell=0.1, unit="h")
path = lc.find_path(lc.Plane(), current, (-3, -1), (3, 1.5))
print(path, path.scope)
path.plot()
plt.show()
