"""`ringfilm conform`: a ring in bores whose closure is known, and what is refused."""

import csv
import json
import math
import random
import unittest

import program

CASE = """title = "Ring in its bore"
[engine]
bore = "89 mm"
[ring]
face_width = "1.2 mm"
radial_thickness = "3.5 mm"
youngs_modulus = "203 GPa"
tangential_force = "10.68 N"
end_gap = "0.35 mm"
[liner]
distortion = [{ order = 4, amplitude = "1 um", phase = "45 degree" }]
"""


FORCE, ORDER_2 = 10.68, 0.25


def free_ring():
    """Angle [degree] and radius [m] of the running surface of the free ring of CASE whose pressure has an order 2 of
    ORDER_2, about a centre of its own: moment, direction and place by sums over a tenth of a degree."""
    r, t, gap = (89e-3 - 3.5e-3) / 2, 3.5e-3, 0.35e-3
    rigidity = 203e9 * 1.2e-3 * t**3 / 12
    start, n = gap / (2 * r), 3600
    step = 2 * (math.pi - start) / n
    middles = [start + (i + 0.5) * step for i in range(n)]

    def moments(force):
        """Of a force per radian, at the middles and at the far end: r times the integral of force(s) sin(phi - s)."""
        found, cosine, sine = [], 0, 0
        for phi in middles:
            half = force(phi) * step / 2
            cosine, sine = cosine + half * math.cos(phi), sine + half * math.sin(phi)
            found.append(r * (math.sin(phi) * cosine - math.cos(phi) * sine))
            cosine, sine = cosine + half * math.cos(phi), sine + half * math.sin(phi)
        end = 2 * math.pi - start
        return found, r * (math.sin(end) * cosine - math.cos(end) * sine)

    target, left = moments(lambda phi: FORCE * (1 + ORDER_2 * math.cos(2 * phi)))
    first_order, left_of_it = moments(math.cos)  # balances what is missing at the gap
    direction, x, y, rows = start, r, 0, []
    for i, (of_target, of_first) in enumerate(zip([*target, 0], [*first_order, 0])):
        if i % 10 == 0:
            outer_x = x + t / 2 * math.cos(direction) + 0.4e-3
            outer_y = y + t / 2 * math.sin(direction) - 1.2e-3
            rows.append((math.degrees(math.atan2(outer_y, outer_x)), math.hypot(outer_x, outer_y)))
        moment = of_target - left / left_of_it * of_first
        turned = step * (1 - r * moment / rigidity)
        x, y = x - r * step * math.sin(direction + turned / 2), y + r * step * math.cos(direction + turned / 2)
        direction += turned
    first = rows[0][0]
    return [((angle - first) % 360, radius) for angle, radius in rows]


class ConformTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE, encoding="utf-8")

    def closure(self, *options, case="case.toml"):
        return json.loads(self.run_well("conform", case, "--json", *options))

    def refused(self, words, *options):
        self.assert_refused(self.run_program("conform", "case.toml", *options), words)

    def test_lifted_tips_end_where_the_closed_form_has_them(self):
        found = self.closure("--set", "ring.end_gap=")
        first, last = found["contact_arcs"][0]
        self.assertEqual(len(found["contact_arcs"]), 1)
        self.assertAlmostEqual(first, 9.102177, places=6)  # verification/thin_ring_closure/reference.py
        self.assertAlmostEqual(last, 360 - first, places=6)
        self.assertAlmostEqual(found["contact_angle"], last - first, places=9)
        self.assertAlmostEqual(found["tangential_force"], 10.68, places=9)
        self.assertLess(found["unbalanced_share"], 1e-12)

    def test_a_pack_is_closed_by_its_first_ring_alone(self):
        alone = self.closure()
        second = '[[ring]]\nface_width = "1.5 mm"\n'
        (self.folder / "pack.toml").write_text(CASE.replace("[ring]", "[[ring]]") + second, encoding="utf-8")
        self.assertEqual(self.closure(case="pack.toml")["contact_arcs"], alone["contact_arcs"])

    def test_the_table_around_sums_up_to_the_values(self):
        found = self.closure("--csv", "around.csv")
        with open(self.folder / "around.csv", encoding="utf-8") as file:
            rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
        self.assertEqual(len(rows), 361)  # 1 to 359 degree, and both ends
        self.run_well("conform", "case.toml", "--html", "around.html")
        self.assertIn('"name":"bore_around"', (self.folder / "around.html").read_text(encoding="utf-8"))
        self.assertAlmostEqual(rows[-1][4], 2 * math.pi * found["mean_wall_force"], places=9)
        self.assertAlmostEqual(max(row[2] for row in rows), found["max_clearance"], delta=1e-9)
        self.assertAlmostEqual(rows[180][5], found["moment_at_back"], places=9)

    def test_the_gap_position_counts_against_the_phase(self):
        turned = self.closure(
            "--set",
            "ring.gap_position='30 degree'",
            "--set",
            "liner.distortion=[{ order = 4, amplitude = '1 um', phase = '75 degree' }]",
        )
        self.assertAlmostEqual(turned["open_area"], self.closure()["open_area"], delta=1e-18)

    def test_cold_and_hot_parts_add_up(self):
        half = "[{ order = 4, amplitude = '0.5 um', phase = '45 degree' }]"
        parts = self.closure("--set", f"liner.distortion={half}", "--set", f"liner.thermal_distortion={half}")
        self.assertAlmostEqual(parts["open_area"], self.closure()["open_area"], delta=1e-18)

    def test_a_map_is_the_bore_that_its_orders_are(self):
        rows = ["height [mm],angle [degree],deviation [um]"]
        for height, share in ((10, 0.5), (30, 1.5)):
            for angle in range(0, 360, 5):
                rows.append(f"{height},{angle},{share * math.cos(math.radians(4 * (angle - 45))):.12f}")
        (self.folder / "bore.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
        (self.folder / "map.toml").write_text(
            CASE.split("distortion =")[0] + 'distortion_map = "bore.csv"\n[conform]\nheight = "20 mm"\n',
            encoding="utf-8",
        )
        of_map = self.closure(case="map.toml")
        self.assertAlmostEqual(of_map["open_area"] / self.closure()["open_area"], 1, places=6)
        # A common slip: the radius in place of its deviation.
        of_radius = ["height [mm],angle [degree],deviation [mm]"] + [
            ",".join([*row.split(",")[:2], "44.4"]) for row in rows[1:]
        ]
        (self.folder / "bore.csv").write_text("\n".join(of_radius) + "\n", encoding="utf-8")
        self.refused(
            "not the radius itself", "--set", "liner.distortion_map=bore.csv", "--set", "conform.height='20 mm'"
        )
        missing = [row for row in rows if not row.startswith("30,100")]
        (self.folder / "bore.csv").write_text("\n".join(missing) + "\n", encoding="utf-8")
        self.refused("has holes", "--set", "liner.distortion_map=bore.csv", "--set", "conform.height='20 mm'")

    def write_free_ring(self, rows):
        text = "angle [degree],radius [mm]\n" + "".join(f"{angle:.8f},{1e3 * radius:.8f}\n" for angle, radius in rows)
        (self.folder / "free.csv").write_text(text, encoding="utf-8")
        tension = 'free_shape = "free.csv"\nfree_shape_smoothing = "40 mm"\n'
        (self.folder / "free.toml").write_text(
            CASE.replace('tangential_force = "10.68 N"\n', tension), encoding="utf-8"
        )

    def test_a_free_shape_has_the_pressure_that_it_was_made_for(self):
        self.write_free_ring(free_ring())
        found = self.closure("--csv", "around.csv", case="free.toml")
        self.assertAlmostEqual(found["tangential_force"] / FORCE, 1, delta=1e-3)
        self.assertEqual(found["free_shape_orders"], 6)  # 268.6 mm around the centroid
        self.assertLess(found["free_shape_residual"], 1e-8)
        for order, amplitude, phase in found["pressure_orders"]:
            self.assertAlmostEqual(amplitude, ORDER_2 if order == 2 else 0, delta=1e-3)
            if order == 2:
                self.assertAlmostEqual(phase, 0, delta=0.1)
        stated = self.closure("--set", f"ring.pressure_orders=[{{ order = 2, amplitude = {ORDER_2} }}]")
        self.assertAlmostEqual(found["projection"] / stated["projection"], 1, delta=2e-3)
        self.assertAlmostEqual(found["moment_at_back"] / stated["moment_at_back"], 1, delta=1e-3)
        # What the table states of the free ring is a free ring again.
        with open(self.folder / "around.csv", encoding="utf-8", newline="") as file:
            table = list(csv.DictReader(file))
        self.write_free_ring([(float(row["free_angle [degree]"]), float(row["free_radius [m]"])) for row in table])
        again = self.closure(case="free.toml")
        self.assertAlmostEqual(again["tangential_force"] / found["tangential_force"], 1, delta=1e-4)

    def write_pressures(self, points):
        text = "angle [degree],pressure [bar]\n" + "".join(f"{angle},{bar:.12g}\n" for angle, bar in points)
        (self.folder / "pressure.csv").write_text(text, encoding="utf-8")

    def test_points_of_the_pressure_are_its_orders(self):
        def bar(angle):
            turn = math.radians(angle)
            # The order 1 is not in balance: the projection takes its place.
            return 3 * (1 + 0.25 * math.cos(2 * turn) - 0.1 * math.sin(5 * turn) + 0.4 * math.cos(turn - 1))

        self.write_pressures([(angle, bar(angle)) for angle in range(-180, 180, 10)])
        orders = "[{ order = 2, amplitude = 0.25 }, { order = 5, amplitude = 0.1, phase = '-18 degree' }]"
        stated = self.closure("--set", f"ring.pressure_orders={orders}")
        found = self.closure("--set", "ring.pressure_points=pressure.csv")
        for name in ("projection", "moment_at_back", "max_clearance", "open_area", "mean_wall_force", "free_gap"):
            self.assertAlmostEqual(found[name] / stated[name], 1, delta=1e-6, msg=name)

    def test_points_of_the_pressure_that_are_none_are_refused(self):
        good = [(angle, 1) for angle in range(0, 360, 20)]
        stated = ("--set", "ring.pressure_points=pressure.csv")
        for points, options, words in (
            (good, ("--set", "ring.pressure_orders=[{ order = 2, amplitude = 0.1 }]"), "stated twice"),
            (good, ("--set", "ring.pressure_points_orders=12"), "is more than 18 points have"),
            (good[:5] + good[6:], (), "degree, where 17 angles over one turn have"),
            (good[:6], (), "has 6 angles"),
            ([(angle, -1) for angle, _ in good], (), "pulls the bore inwards"),
        ):
            self.write_pressures(points)
            self.refused(words, *stated, *options)

    def test_noise_of_a_free_shape_is_smoothed_and_its_effect_stated(self):
        noise = random.Random(1)
        self.write_free_ring([(angle, radius + noise.gauss(0, 0.1e-6)) for angle, radius in free_ring()])
        spread = {}
        for smoothing in ("80 mm", "40 mm", "15 mm"):
            found = self.closure("--set", f"ring.free_shape_smoothing={smoothing}", case="free.toml")
            self.assertAlmostEqual(found["free_shape_residual"], 0.1e-6, delta=0.02e-6)
            spread[smoothing] = found["pressure_deviation"]
        self.assertLess(spread["80 mm"], 2e-3)
        self.assertGreater(spread["15 mm"], 100 * spread["80 mm"])

    def test_free_shapes_that_are_none_are_refused(self):
        rows = free_ring()
        self.write_free_ring(rows)
        for settings, words in (
            (("ring.free_shape_smoothing=",), "ring.free_shape_smoothing is missing"),
            (("ring.free_shape_smoothing=1 mm",), "leaves 268 orders"),
            (("ring.free_shape_smoothing=40",), "has no unit"),
            (("ring.pressure_orders=[{ order = 2, amplitude = 0.1 }]",), "stated twice"),
            (("ring.end_gap=20 mm",), "does not close"),
            (("ring.radial_thickness=",), "ring.radial_thickness"),
        ):
            options = [word for setting in settings for word in ("--set", setting)]
            self.assert_refused(self.run_program("conform", "free.toml", *options), words)
        text = (self.folder / "free.toml").read_text(encoding="utf-8")
        twice = text.replace("free_shape =", 'tangential_force = "10 N"\nfree_shape =')
        (self.folder / "twice.toml").write_text(twice, encoding="utf-8")
        self.assert_refused(self.run_program("conform", "twice.toml"), "stated twice")
        for of, words in (
            (rows[:200], "does not close"),
            (rows[:10], "fewer than"),
            ([*rows[:100], *rows[99:]], "does not rise"),
            ([(angle, -radius) for angle, radius in rows], "not a distance"),
            ([(math.radians(angle), radius) for angle, radius in rows], "does not close"),
        ):
            self.write_free_ring(of)
            self.assert_refused(self.run_program("conform", "free.toml"), words)

    def test_a_dynamic_bore_that_is_not_periodic_or_has_holes_is_refused(self):
        shipped = str(program.SOURCES / "cases/distorted-bore/followed.toml")
        stated = ("--set", "liner.dynamic_distortion=dynamic.csv")
        head = "crank_angle [degree],angle [degree],deviation [um]"
        rows = [
            f"{crank},{angle},{crank % 720 / 100 + angle % 360 / 360}"
            for crank in range(-360, 361, 10)
            for angle in range(0, 360, 30)
        ]
        last = -12
        for written, words in (
            ([head, *rows], None),
            ([head, *rows[:last]], None),
            ([head, *rows[:last], *[row + "1" for row in rows[last:]]], "is not that of one cycle before"),
            ([head, *rows[:24], *rows[36:]], "is not known between -350 and -330 degree crank angle"),
            ([head, *rows[:100], *rows[101:]], "has holes"),
            ([head.replace("crank_angle [degree]", "crank_angle [mm]"), *rows], "mm"),
            ([head.replace("[um]", "[N]"), *rows], "N"),
            ([head.replace("[um]", "[mm]"), *rows], "check its unit"),
            ([head.replace("crank_angle [degree]", "height [mm]"), *rows], "crank_angle"),
        ):
            (self.folder / "dynamic.csv").write_text("\n".join(written) + "\n", encoding="utf-8")
            if words is None:
                self.run_well("check", shipped, *stated)
            else:
                self.assert_refused(self.run_program("check", shipped, *stated), words)

    def test_a_whole_case_and_its_closure_alone_are_the_same(self):
        shipped = program.SOURCES / "cases/distorted-bore/followed.toml"
        found = self.closure(case=str(shipped))
        self.assertAlmostEqual(found["max_clearance"] * 1e6, 1.568, delta=0.001)
        opposite = self.closure("--set", "ring.gap_position='180 degree'", case=str(shipped))
        self.assertAlmostEqual(opposite["max_clearance"] * 1e6, 0.112, delta=0.001)

    def test_what_is_impossible_is_refused(self):
        for setting, words in (
            ("liner.distortion=[{ order = 2, amplitude = '60 mm' }]", "leave no bore"),
            ("liner.distortion=[{ order = 2, amplitude = 15 }]", "has no unit"),
            ("liner.distortion=[{ order = 2, amplitude = '15 um', height = '1 mm' }]", "conform.height is missing"),
            ("ring.end_gap='300 mm'", "circumference"),
            ("ring.radial_thickness='-1 mm'", "out of range"),
            ("ring.radial_thickness=", "ring.radial_thickness is missing"),
            ("ring.pressure_orders=[{ order = 1, amplitude = 0.1 }]", "is not an order"),
            ("conform.gas_pressure='-1 bar'", "out of range"),
        ):
            self.refused(words, "--set", setting)

    def test_a_cycle_states_that_its_bore_is_round(self):
        shipped = program.SOURCES / "cases/distorted-bore/followed.toml"
        checked = json.loads(self.run_well("check", str(shipped), "--set", "ring.conformity=rigid", "--json"))
        self.assertIn("bore-taken-as-round", json.dumps(checked["notes"]))
        bends = json.loads(self.run_well("check", str(shipped), "--json"))
        self.assertNotIn("bore-taken-as-round", json.dumps(bends["notes"]))

    def test_the_shipped_rings_bend_over_the_whole_cycle(self):
        coarse = ("--set", "solver.cells=50", "--set", "solver.cells_y=60", "--set", "solver.crank_step=4 degree")
        coarse += ("--set", "output.crank_angles=4 degree")
        clearance, film = {}, {}
        for name in ("followed", "dynamic", "not-followed"):
            shipped = str(program.SOURCES / f"cases/distorted-bore/{name}.toml")
            found = json.loads(self.run_well("run", shipped, *coarse, "--json"))
            clearance[name], film[name] = found["peak_clearance"], found["min_film_thickness"]
            self.assertLess(found["effort"]["max_load_residual"], 1e-6)
            self.assertGreater(found["mean_open_area"], 0)
        self.assertGreater(clearance["not-followed"], clearance["followed"])
        self.assertLess(film["dynamic"], 0.9 * film["followed"])  # the tips press on the bulge beside the gap
        printed = " ".join(self.run_well("run", shipped, *coarse).split())
        self.assertIn("the ring bends: largest clearance", printed)

    def test_a_ring_that_bends_needs_its_thickness_and_the_whole_stroke(self):
        shipped = str(program.SOURCES / "cases/distorted-bore/followed.toml")
        for setting, words in (
            ("ring.radial_thickness=", "ring.radial_thickness is missing"),
            ("ring.conformity=soft", "ring.conformity"),
            (
                "liner.distortion=[{ order = 2, amplitude = '9 um', height = '0 mm' }, "
                "{ order = 2, amplitude = '5 um', height = '50 mm' }]",
                "the ring passes 0 to 79.5 mm",
            ),
        ):
            self.assert_refused(self.run_program("check", shipped, "--set", setting), words)


if __name__ == "__main__":
    unittest.main()
