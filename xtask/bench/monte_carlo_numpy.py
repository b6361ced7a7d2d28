"""Table D.1 of ISO 16063-21 by Monte Carlo with numpy, one thread.

Prints {"draws_per_second": ...}: whole model evaluations, best of five runs.
"""

import json
import os
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")
import numpy as np  # noqa: E402

# Half-widths in percent of the rectangular factors, and the divided one.
RECTANGULAR = [0.15, 0.2, 0.36, 0.2, 0.05, 0.0024, 0.05, 0.05]
RECTANGULAR += [0.03, 0.03, 0.03, 0.03, 0.03]
BATCH = 100_000
BATCHES = 16


def trials(rng, count):
    """Relative deviations of the sensitivity in percent."""
    above = 1 + 0.0025 * rng.standard_normal(count)
    for half in RECTANGULAR:
        above *= 1 + rng.uniform(-half / 100, half / 100, count)
    size = rng.uniform(-1, 1, count) * rng.uniform(-1, 1, count)
    above *= 1 + 0.0051 * size * np.cos(2 * np.pi * rng.random(count))
    below = 1 + rng.uniform(-0.0025, 0.0025, count)
    return (above / below - 1) * 100


def main():
    rng = np.random.default_rng(1)
    best = 0.0
    for _ in range(5):
        start = time.perf_counter()
        for _ in range(BATCHES):
            values = trials(rng, BATCH)
        best = max(best, BATCH * BATCHES / (time.perf_counter() - start))
    print(json.dumps({"draws_per_second": best, "u_percent": float(values.std())}))


if __name__ == "__main__":
    main()
