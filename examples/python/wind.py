# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The quickest course around an eddy whose current is given on a grid."""
import leastcost as lc
import matplotlib.pyplot as plt

current = lc.cost.zermelo(speed=1, flow={"type": "grid", "file": "configs/data/eddy.csv"}, unit="h")
ends = {"source": {"point": [-3, -1]}, "target": {"point": [3, 1.5]}}
path = lc.run({"manifold": lc.manifold.euclidean(dimension=2), "cost": current, "ends": ends})
print(path, path.scope)
path.plot()
plt.show()
