#!/usr/bin/env python3
"""The assignment solver against scipy's: assignment_scipy_test.py PATH_OF_SOLVE_ASSIGNMENTS. Skipped where scipy is not installed.

If this fails, tracks get plots or partners that are not the best ones.
"""
import random
import subprocess
import sys
import unittest

try:
    import numpy
    import scipy.optimize
except ImportError:
    scipy = None

PROGRAM = sys.argv.pop(1)
SHAPES = [(1, 1), (2, 3), (3, 2), (5, 5), (10, 10), (10, 25), (40, 17), (100, 100), (60, 300), (300, 60), (300, 300)]


@unittest.skipIf(scipy is None, "scipy is not installed")
class AssignmentAgainstScipy(unittest.TestCase):
    def check(self, draw):
        seed = random.randrange(2**32)
        print(f"seed {seed}")
        generator = numpy.random.default_rng(seed)
        matrices = [draw(generator, shape) for shape in SHAPES for _ in range(3)]
        text = "\n".join(" ".join(map(repr, [*m.shape, *map(float, m.ravel())])) for m in matrices)
        said = subprocess.run([PROGRAM], input=text, stdout=subprocess.PIPE, text=True, check=True, timeout=60).stdout.split()
        self.assertEqual(len(said), len(matrices))
        for matrix, least in zip(matrices, said):
            best = matrix[scipy.optimize.linear_sum_assignment(matrix)].sum()
            self.assertAlmostEqual(float(least), best, delta=1e-9 * max(1.0, abs(best)), msg=f"shape {matrix.shape}, seed {seed}")

    def test_real_costs_of_any_sign(self):
        self.check(lambda generator, shape: generator.normal(0.0, 100.0, shape))

    def test_whole_costs_with_many_ties(self):
        self.check(lambda generator, shape: generator.integers(0, 5, shape).astype(float))

    def test_distances_of_near_pairs(self):
        def draw(generator, shape):
            rows, columns = (generator.uniform(0.0, 1.0, (n, 2)) for n in shape)
            return numpy.linalg.norm(rows[:, None] - columns[None, :], axis=2)
        self.check(draw)


if __name__ == "__main__":
    unittest.main()
