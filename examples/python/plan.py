# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The shortest plan around a disc and a wall with a clearance, proved to be the shortest of all."""
import leastcost as lc
import matplotlib.pyplot as plt

box = lc.manifold.euclidean(lower=[0, 0], upper=[10, 6])
obstacles = [lc.obstacle.ball(center=[3, 3], radius=1), lc.obstacle.box(lower=[6, 0], upper=[6.2, 4])]
ends = {"source": {"point": [1, 3]}, "target": {"point": [9, 1]}}
path = lc.run({"manifold": box, "obstacles": obstacles, "clearance": 0.2, "cost": "euclidean", "ends": ends})
print(path, path.scope)
path.plot()
plt.show()
