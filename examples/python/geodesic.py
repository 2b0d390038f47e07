# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""A geodesic on a scan, proved to be the shortest of all paths on it."""
import leastcost as lc
import matplotlib.pyplot as plt

mesh = lc.Mesh.read("configs/data/hill.obj")
path = mesh.geodesic(0, 80)
print(path.length, "proved" if path.proved else path.reason)
path.plot(mesh.plot())
plt.show()
