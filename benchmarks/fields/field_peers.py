#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Fields of least costs on rasters beside scikit-fmm and MCP_Geometric of scikit-image: processor time and error.

    field_peers.py PROGRAM [--library field_raster_table] [--terrain DEM.csv] [--cells 2000] [--repeats 3]

All run on one core, in turn, each repeat in a process of its own; the time is the least of the repeats. Ours are the
program (start, reading the raster, field, estimate of the error, file) and the field of the library alone. Theirs is
the call alone, with the array in memory. Errors are of a part of each raster, of at most 401 x 401 cells, against fields on a lattice eight times as fine
by scikit-fmm (order 2) and by ours: the largest and the mean difference from each, of the largest value. The source of
scikit-fmm is a node, or a circle of three cells around it, whichever is nearer to the reference.
Speed was tuned on "uniform" and "smooth", and nothing on the others.
"""
import argparse
import multiprocessing
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.ndimage

try:
    import skfmm
except ImportError:
    skfmm = None
try:
    from skimage.graph import MCP_Geometric
except ImportError:
    MCP_Geometric = None

FINER = 8
PART = 401


def smooth_noise(random, cells, sigma):
    noise = scipy.ndimage.gaussian_filter(random.standard_normal((cells, cells)), sigma, mode="wrap")
    return noise / noise.std()


def fractal(cells):
    """exp of noise with a spectrum of a power of the frequency."""
    random = np.random.default_rng(987001)
    frequency = np.hypot(np.fft.fftfreq(cells)[:, None], np.fft.fftfreq(cells)[None])
    frequency[0, 0] = 1
    noise = np.fft.ifft2(np.fft.fft2(random.standard_normal((cells, cells))) * frequency**-1.5).real
    return np.exp(0.7 * noise / noise.std())


def city(cells):
    """Streets of about 1, yards of 3, walls of 200, most with a door of 1.5, and courts without data."""
    random = np.random.default_rng(987002)
    costs = np.ones((cells, cells))

    def cuts():
        return np.unique(np.concatenate([[0], np.cumsum(random.integers(25, 90, cells // 25))]).clip(0, cells))

    rows, columns = cuts(), cuts()
    for top, bottom in zip(rows[:-1], rows[1:]):
        for left, right in zip(columns[:-1], columns[1:]):
            street, kind = int(random.integers(2, 6)), random.random()
            if bottom - top < 2 * street + 8 or right - left < 2 * street + 8:
                continue
            block = (slice(top + street, bottom - street), slice(left + street, right - street))
            if kind < 0.55:
                costs[block] = 200
                inside = (slice(top + street + 3, bottom - street - 3), slice(left + street + 3, right - street - 3))
                costs[inside] = 3 if random.random() < 0.6 else np.nan
                if random.random() < 0.7:
                    middle = (top + bottom) // 2
                    costs[middle - 1 : middle + 2, left + street : left + street + 3] = 1.5
            elif kind < 0.75:
                costs[block] = 3
            elif kind < 0.85:
                costs[block] = np.nan
    return costs * np.exp(0.2 * smooth_noise(random, cells, 25))


def rasters(cells, terrain):
    """Name to costs, NaN: impassable; with the part of it that errors are measured on, and the source in it."""
    random = np.random.default_rng(20261128)
    yield "uniform", np.ones((cells, cells))
    yield "smooth", np.exp(0.8 * smooth_noise(random, cells, 60))
    yield "rough", np.exp(random.standard_normal((cells, cells)))
    blocked = np.exp(0.5 * smooth_noise(random, cells, 40))
    blocked[smooth_noise(random, cells, 12) > 1.3] = np.nan
    yield "smooth, with holes", blocked
    yield "fractal", fractal(cells)
    yield "city", city(cells)
    if terrain is None:
        print("terrain: skipped, as no file of heights was given (--terrain)")
        return
    heights = np.loadtxt(terrain, delimiter=",")
    side = min(heights.shape)
    heights = scipy.ndimage.zoom(heights[:side, :side], cells / side, order=3)[:cells, :cells]
    rise = np.hypot(*np.gradient(heights, 80 * side / cells))  # cells of about 80 m
    costs = 1 + 8 * rise
    costs[rise > np.quantile(rise, 0.97)] = np.nan
    yield "terrain, steep parts impassable", costs


def near(costs, place):
    """The passable cell that is nearest to a place in the middle of a passable part."""
    open_cells = scipy.ndimage.binary_erosion(np.isfinite(costs), iterations=4)
    rows, columns = np.nonzero(open_cells)
    k = np.argmin((rows - place[0]) ** 2 + (columns - place[1]) ** 2)
    return int(rows[k]), int(columns[k])


def finer(costs):
    """Bilinear between the values; no value in a cell with a corner that has none."""
    n = costs.shape[0]
    at = np.arange(FINER * (n - 1) + 1) / FINER
    low = np.minimum(at.astype(int), n - 2)
    t = at - low

    def along_rows(a):
        s = t[:, None]
        return np.where(s == 0, a[low], np.where(s == 1, a[low + 1], (1 - s) * a[low] + s * a[low + 1]))

    return along_rows(along_rows(costs).T).T


class Ours:
    """The program, on a file that is written beforehand."""

    def __init__(self, program):
        self.program = program

    def prepare(self, costs, source, folder):
        from PIL import Image

        Image.fromarray(np.where(np.isfinite(costs), costs, -1).astype(np.float32)).save(os.path.join(folder, "c.tif"))
        with open(os.path.join(folder, "map.yaml"), "w") as out:
            out.write("manifold: euclidean\ncost: {type: cost_map, interpolation: bilinear, cell: 1, origin: [0, 0], "
                      "nodata: -1, file: c.tif}\n")
        self.folder, self.rows = folder, costs.shape[0]
        self.place = f"{source[1] + 0.5},{costs.shape[0] - source[0] - 0.5}"

    def run(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([self.program, "field", "map.yaml", "-o", "f.npy", "--from", self.place],
                              cwd=self.folder, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode not in (0, 5):
            raise RuntimeError(done.stderr)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return seconds, np.load(os.path.join(self.folder, "f.npy"))


def library(program, costs, source, folder):
    """Seconds of the field alone."""
    file = os.path.join(folder, "costs.bin")
    np.flipud(costs).astype(np.float64).tofile(file)
    cells = costs.shape[0]
    row = cells - 1 - source[0]
    done = subprocess.run([program, file, str(cells), str(source[1]), str(row)], capture_output=True, text=True,
                          check=True)
    return float(done.stdout.split()[0]), None


def marched(costs, source, order, circle):
    """By scikit-fmm."""
    rows, columns = np.ogrid[: costs.shape[0], : costs.shape[1]]
    if circle:
        phi = np.hypot(rows - source[0], columns - source[1]) - 3.0
    else:
        phi = np.ones(costs.shape)
        phi[source] = 0
    phi = np.ma.MaskedArray(phi, ~np.isfinite(costs))
    speed = 1 / np.where(np.isfinite(costs), costs, 1)
    begin = time.process_time()
    field = skfmm.travel_time(phi, speed, order=order)
    seconds = time.process_time() - begin
    values = np.ma.filled(np.ma.asarray(field).astype(float), np.nan)
    if circle:  # inside, and up to it, straight
        values = values + 3.0 * costs[source]
        inside = np.hypot(rows - source[0], columns - source[1]) <= 3.0
        values[inside] = (np.hypot(rows - source[0], columns - source[1]) * 0.5 * (costs[source] + costs))[inside]
    return seconds, values


def routed(costs, source):
    """By MCP_Geometric."""
    costs = np.where(np.isfinite(costs), costs, -1)
    begin = time.process_time()
    field, _ = MCP_Geometric(costs).find_costs([source])
    seconds = time.process_time() - begin
    return seconds, np.where(np.isfinite(field), field, np.nan)


def apart(work, *given):
    """In a process of its own, on one core."""
    ours, theirs = multiprocessing.Pipe(False)
    child = os.fork()
    if child == 0:
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
        theirs.send(work(*given))
        os._exit(0)
    theirs.close()
    answer = ours.recv()
    os.waitpid(child, 0)
    return answer


def methods(given, costs, source, folder):
    ours = Ours(given.program)
    ours.prepare(costs, source, folder)
    found = {"leastcost field": [ours.run]}
    if given.library:
        found["library, field alone"] = [lambda: library(given.library, costs, source, folder)]
    if skfmm is not None:
        for order in (1, 2):
            found[f"scikit-fmm, order {order}"] = [
                lambda circle=circle, order=order: marched(costs, source, order, circle) for circle in (False, True)]
    if MCP_Geometric is not None:
        found["MCP_Geometric"] = [lambda: routed(costs, source)]
    return found


def difference(values, reference):
    both = np.isfinite(values) & np.isfinite(reference)
    apart = np.abs(values - reference)[both]
    return apart.max(), apart.mean()


def errors(given, costs, source):
    """Method to (largest, mean) against each reference, and the largest value."""
    with tempfile.TemporaryDirectory() as folder:
        found = {name: [work()[1] for work in works] for name, works in
                 methods(given, costs, source, folder).items() if not name.startswith("library")}
    fine, at = finer(costs), (FINER * source[0], FINER * source[1])
    references = {}
    with tempfile.TemporaryDirectory() as folder:
        ours = Ours(given.program)
        ours.prepare(fine, at, folder)
        references["ours"] = ours.run()[1] / FINER
    if skfmm is not None:
        references["scikit-fmm"] = marched(fine, at, 2, True)[1] / FINER
    table = {}
    for name, fields in found.items():
        table[name] = {}
        for by, reference in references.items():
            part = reference[::FINER, ::FINER]
            table[name][by] = min(difference(field, part) for field in fields)
    return table, np.nanmax(references["ours"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", help="leastcost")
    parser.add_argument("--library", help="field_raster_table, for the time of the field alone")
    parser.add_argument("--terrain", help="heights as CSV, cells of about 80 m")
    parser.add_argument("--cells", type=int, default=2000)
    parser.add_argument("--repeats", type=int, default=3)
    given = parser.parse_args()
    given.program = os.path.abspath(given.program)
    given.library = given.library and os.path.abspath(given.library)
    os.environ["OMP_NUM_THREADS"] = "1"
    for name, module in (("scikit-fmm", skfmm), ("MCP_Geometric", MCP_Geometric)):
        if module is None:
            print(f"{name}: skipped, as it is not installed")
    for name, costs in rasters(given.cells, given.terrain):
        source = near(costs, (0.31 * given.cells, 0.42 * given.cells))
        seconds = {}
        with tempfile.TemporaryDirectory() as folder:
            works = methods(given, costs, source, folder)
            for _ in range(given.repeats):
                for method, variants in works.items():
                    seconds.setdefault(method, []).append(min(apart(lambda w=work: w()[0]) for work in variants))
        low = [max(0, min(s - PART // 2, given.cells - PART)) for s in source]
        part = costs[low[0] : low[0] + PART, low[1] : low[1] + PART]
        wrong, largest = errors(given, part, (source[0] - low[0], source[1] - low[1]))
        wrong["library, field alone"] = wrong["leastcost field"]
        ours = min(seconds.get("library, field alone", seconds["leastcost field"]))
        print(f"\n{name}: {given.cells} x {given.cells}; errors of a part of {part.shape[0]} x {part.shape[1]}, "
              f"in % of {largest:.4g}")
        for method, all_seconds in seconds.items():
            told = "   ".join(f"against {by}: {100 * worst / largest:8.4f} {100 * mean / largest:8.4f}"
                              for by, (worst, mean) in wrong[method].items())
            print(f"  {method:20s} {min(all_seconds):6.2f} s   field alone / this {ours / min(all_seconds):5.2f}   {told}",
                  flush=True)


if __name__ == "__main__":
    sys.exit(main())
