"""`ring.local_deformation`: how much the faces of the shipped rings give way, against Hertz, and what is refused."""

import json
import math
import unittest

import program

SHIPPED = program.SOURCES / "cases" / "styles2014"
COARSE = ("--set", "solver.cells=100", "--set", "solver.crank_step=2 degree", "--set", "output.crank_angles=2 degree")
HALF_SPACE = ("--set", "ring.local_deformation=half-space")


class LocalDeformationTest(program.ProgramTest):
    def run_ring(self, name, *options):
        return json.loads(self.run_well("run", str(SHIPPED / f"{name}.toml"), *COARSE, *options, "--json"))

    def test_faces_give_way_by_what_hertz_estimates(self):
        composite_modulus = 2 / ((1 - 0.3**2) / 203e9 + (1 - 0.211**2) / 92.3e9)
        # 62 bar behind the ring and 0.2 MPa of tension on 1.2 mm at 20 degree, and without the mean gas at the edges.
        load = (62e5 + 2e5) * 1.2e-3
        excess = load - 0.5 * (62e5 + 1.01325e5) * 1.2e-3
        low, high = (4 * w / (math.pi * composite_modulus) for w in (excess, load))
        self.assertAlmostEqual(low * 1e6, 0.04, delta=0.005)
        self.assertAlmostEqual(high * 1e6, 0.07, delta=0.005)
        for name in ("new", "embedded"):
            rigid, elastic = self.run_ring(name), self.run_ring(name, *HALF_SPACE)
            # Over the edges of the face, half a face away, it is more than over the contact alone.
            self.assertGreater(elastic["peak_local_deformation"], high)
            self.assertLess(elastic["peak_local_deformation"], 2 * high)
            self.assertAlmostEqual(
                elastic["peak_local_deformation_angle"], 20, delta=2
            )  # highest gas pressure; one step
            more = elastic["min_film_thickness"] - rigid["min_film_thickness"]
            self.assertGreater(more, 0)
            self.assertLess(more, low)

    def test_what_it_does_not_hold_for_is_refused(self):
        for setting, words in (
            ("film.dimension=unrolled", "is for the film across the face alone"),
            ("ring.face.orientation=leading-edge", "needs a face that stays as it is installed"),
            ("ring.local_deformation=plate", "half-space"),
        ):
            options = HALF_SPACE if "local_deformation" not in setting else ()
            case = str(SHIPPED / "new.toml")
            self.assert_refused(self.run_program("check", case, *options, "--set", setting), words)


if __name__ == "__main__":
    unittest.main()
