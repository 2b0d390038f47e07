# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The curve of fastest descent, by a cost written in numpy: the squared times of beads on n straight chutes."""
import leastcost as lc
import matplotlib.pyplot as plt
import numpy as np


def chute(a, b):
    return 2 * ((b - a) ** 2).sum(0) / (np.sqrt(-a[1]) + np.sqrt(-b[1])) ** 2


path = lc.find_path(lc.Plane(), chute, (0, 0), (np.pi, -2), points=40, unit="s", additive=True)
print(path, path.scope)
path.plot()
plt.show()
