# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What the Python package costs (docs/python.md): import, memory, geodesics, solves.

    PYTHONPATH=build/release/python /usr/bin/python3 python/benchmarks/measure.py MESH [PAIRS] [SOLVES]

The same geodesics in C++: python/benchmarks/geodesics.cpp, with the pairs that this writes as results/pairs.txt.
"""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

IMPORT = """
import time, os
import numpy
a = time.process_time()
rss = lambda: int(open('/proc/self/statm').read().split()[1]) * os.sysconf('SC_PAGE_SIZE') / 1e6
before = rss()
import leastcost
print(f'import after numpy: {1e3 * (time.process_time() - a):.0f} CPU ms; resident {before:.1f} -> {rss():.1f} MB')
"""


def main() -> None:
    for _ in range(3):
        subprocess.run([sys.executable, "-c", IMPORT], check=True)

    import leastcost as lc
    import numpy as np

    mesh = lc.Mesh.read(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    pairs = np.random.default_rng(1).integers(0, len(mesh.V), (count, 2))
    Path("results").mkdir(exist_ok=True)
    np.savetxt("results/pairs.txt", pairs, fmt="%d")
    start = time.process_time()
    total, proved = 0.0, 0
    for s, t in pairs.tolist():
        geodesic = mesh.geodesic(s, t)
        total += geodesic.length
        proved += geodesic.proved
    print(f"{count} geodesics: {time.process_time() - start:.2f} CPU s, sum {total:.12f}, proved {proved}")

    chute = {
        "manifold": lc.manifold.euclidean(dimension=2),
        "cost": lc.cost.travel_time(gravity=1),
        "ends": {"source": {"point": [0, 0]}, "target": {"point": [3, -2]}},
        "path": {"points": 10},
    }
    solves = int(sys.argv[3]) if len(sys.argv) > 3 else 10_000
    start = time.process_time()
    for i in range(solves):
        lc.run(chute)
        if i in (solves // 10, solves - 1):
            print(f"after {i + 1} solves: resident {resident():.1f} MB, {time.process_time() - start:.1f} CPU s")
    print(f"largest: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3:.1f} MB")


def resident() -> float:
    """MB."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


if __name__ == "__main__":
    main()
