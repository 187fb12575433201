"""benchmarks/budget.py: what perf prints is read, and each function's time is put where it belongs"""

import os
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "benchmarks"))

import budget  # noqa: E402

REPORT = """# To display the perf.data header info, please use --header/--header-only options.
#
# Overhead       Samples  Shared Object                            Symbol
    21.30%           353  libompl_certificates.so.0.2.0            [.] ompl_certificates::overlaps<ompl_certificates::TriangleTree::Node>    -      -
     4.00%            66  libompl_certificates.so.0.2.0            [.] ompl_certificates::CertificateTree::covering
     3.50%            58  libompl_certificates.so.0.2.0            [.] ompl_certificates::CertificateTree::store
     3.00%            50  libompl_certificates.so.0.2.0            [.] ompl_certificates::CertifiedEnvironment::settleByHint
     2.78%            46  [vdso]                                   [.] __vdso_clock_gettime
     2.29%            38  libm.so.6                                [.] __sincos_fma
     2.00%            33  libm.so.6                                [.] __ieee754_acos_fma
     1.90%            31  libompl_certificates_neighbors.so.0.2.0  [.] ompl_certificates::StateKdTree::searchLeaf
     1.81%            30  libompl.so.1.5.2                         [.] ompl::base::RealVectorStateSampler::sampleUniform
     1.63%            27  libompl.so.1.5.2                         [.] ompl::base::CompoundStateSpace::interpolate
     1.51%            25  libompl.so.1.5.2                         [.] ompl::geometric::RRTstar::solve
     1.39%            23  libompl_certificates.so.0.2.0            [.] ompl_certificates::RobotPairs::TwoBodies::gap
     1.21%            20  libompl_certificates.so.0.2.0            [.] ompl_certificates::Statistics::add
     1.10%            18  libompl_certificates.so.0.2.0            [.] ompl_certificates::TriangleTree::distance
     1.00%            17  libompl_certificates.so.0.2.0            [.] ompl_certificates::TeamCheck::isFreeByStandard
     0.50%             8  libfcl.so.0.7.0                          [.] fcl::detail::MeshCollisionTraversalNode<fcl::OBBRSS<double> >::leafTesting
     0.40%             7  libc.so.6                                [.] cfree@GLIBC_2.2.5
"""


class Budget(unittest.TestCase):
    def test_puts_functions_where_they_belong(self):
        counts = {name: count for name, count in budget.group(budget.read_samples(REPORT)).items() if count}
        self.assertEqual(counts, {"contact": 353, "lookups": 66, "new certificates": 58, "hints": 50, "clocks": 46,
                                  "poses": 38, "states": 33 + 27, "neighbors": 31, "random numbers": 30, "planner": 25,
                                  "pairs": 23, "counters, locks": 20, "clearances": 18, "checks": 17, "FCL": 8, "other": 7})

    def test_prints_all_categories_once(self):
        self.assertEqual(set(budget.CHECKS) - {name for name, _ in budget.CATEGORIES}, set())

    def test_refuses_what_makes_no_sense(self):
        for arguments, word in ((["nowhere"], "nowhere"), ([".", "--scenes", "moon"], "moon")):
            run = subprocess.run([sys.executable, os.path.join(ROOT, "benchmarks", "budget.py"), *arguments],
                                 capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 2)
            self.assertEqual(len(run.stderr.splitlines()), 1)
            if "not installed" not in run.stderr:
                self.assertIn(word, run.stderr)


if __name__ == "__main__":
    unittest.main()
