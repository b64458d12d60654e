"""Runs: progress, Ctrl-C, other threads, other processes, many cases at once."""

import concurrent.futures
import operator
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy
import pytest

import ringfilm
from conftest import PAD


@pytest.fixture
def slider():
    return ringfilm.Case.read(PAD / "inclined_slider.toml")


@pytest.fixture
def slow(case):
    """A case of some seconds."""
    case["solver.cells"] = 2000
    case["solver.crank_step"] = "0.25 degree"
    case["output.crank_angles"] = "10 degree"
    return case


def test_progress_is_reported(slow):
    reported = []
    slow["solver.cells"] = 200
    slow.run(progress=lambda cycle, angle: reported.append((cycle, angle)))
    assert reported and reported[0][0] == 1
    assert all(0 <= angle <= 720 for _, angle in reported)
    assert reported == sorted(reported, key=lambda one: one[0])


def test_what_progress_raises_ends_the_run(slow):
    class Enough(Exception):
        pass

    def progress(cycle, angle):
        raise Enough

    with pytest.raises(Enough):
        slow.run(progress=progress)


def test_other_threads_continue(slow):
    beats = []
    done = threading.Event()

    def beat():
        while not done.is_set():
            beats.append(time.perf_counter())
            time.sleep(0.005)

    thread = threading.Thread(target=beat)
    thread.start()
    begin = time.perf_counter()
    slow.run()
    end = time.perf_counter()
    done.set()
    thread.join()
    during = [at for at in beats if begin < at < end]
    # A held lock would let none through; a tenth of the beats is enough on a busy machine.
    assert len(during) > (end - begin) / 0.005 / 10


@pytest.mark.parametrize(
    "how",
    [
        "case.run()",
        "case.run(error_estimate=True)",
        "ringfilm.simulate_many([case] * 3)",
        "ringfilm.Study.read('study.toml').run()",
    ],
)
def test_ctrl_c_stops_what_would_continue_for_minutes(folder, how):
    script = textwrap.dedent(
        f"""
        import pathlib, ringfilm, sys
        case = ringfilm.Case.read("case.toml")
        case["solver.cells"] = 20000
        case["solver.crank_step"] = "0.02 degree"
        case["output.crank_angles"] = "10 degree"
        pathlib.Path("slow.toml").write_text(case.resolved())
        pathlib.Path("study.toml").write_text('''
            kind = "map"
            [[base]]
            name = "slow"
            case = "slow.toml"
            [[factor]]
            name = "speed"
            key = "operating.speed"
            values = ["1000 rpm", "2000 rpm", "3000 rpm"]
            [plan]
            method = "grid"
        ''')
        print("running", flush=True)
        try:
            {how}
        except KeyboardInterrupt:
            sys.exit(77)
        """
    )
    process = subprocess.Popen([sys.executable, "-c", script], cwd=folder, stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"running\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 77, "it ended by itself, or of another cause"


def test_a_cycle_that_stops_reports_where_and_keeps_what_it_passed(case):
    # No film can carry a load that rises without bound at a liner that does not move away: speed near zero, huge gas.
    case["contact.asperity_density"] = "1e-6 um-2"
    case["contact.roughness"] = "0.01 um"
    case["ring.elastic_pressure"] = "60 MPa"
    case["ring.face.crown_height"] = "200 um"
    case["ring.face.apex"] = 0.0  # no wedge on the way up
    try:
        case.run()
    except ringfilm.ConvergenceError as stop:
        assert str(stop)
        assert stop.result is not None and not stop.result.complete
        assert numpy.isnan(stop.result.fmep)
    else:
        pytest.skip("this case is solved by now; find a harder one")


def test_threads_give_the_same_bits(case):
    expected = case.run().min_film_thickness.copy()
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for result in pool.map(lambda _: case.copy().run(), range(8)):
            numpy.testing.assert_array_equal(result.min_film_thickness, expected)


@pytest.mark.parametrize("executor", ["ThreadPoolExecutor", "ProcessPoolExecutor"])
def test_executors_give_the_same_bits(case, executor):
    expected = case.run()
    with getattr(concurrent.futures, executor)(2) as pool:
        for result in pool.map(operator.methodcaller("run"), [case] * 3):
            numpy.testing.assert_array_equal(result.min_film_thickness, expected.min_film_thickness)
            assert result.fmep == expected.fmep


def many(case, n):
    for i in range(n):
        one = case.copy()
        one["operating.speed"] = f"{1000 + 100 * i} rpm"
        yield one


def test_many_cases_come_back_in_their_order(case):
    reported = []
    batch = ringfilm.simulate_many(many(case, 9), progress=lambda done, total: reported.append((done, total)))
    assert len(batch) == 9 and reported == [(i, None) for i in range(1, 10)]
    for i, result in enumerate(batch):
        expected = next(iter(list(many(case, 9))[i : i + 1])).run()
        # Films side by side leave what the iteration may leave.
        assert result.fmep == pytest.approx(expected.fmep, rel=1e-6)
        numpy.testing.assert_allclose(result.min_film_thickness, expected.min_film_thickness, rtol=1e-5)


def test_the_numbers_do_not_depend_on_threads(case):
    cases = list(many(case, 12))
    one, three = (ringfilm.simulate_many(cases, threads=n, curves="none") for n in (1, 3))
    assert [result.values for result in one] == [result.values for result in three]
    assert one[0].min_film_thickness.size == 0


def test_a_case_that_cannot_be_run_is_a_row_with_its_reason(case):
    bad = case.copy()
    bad["ring.tangential_force"] = "12 N"
    batch = ringfilm.simulate_many([case, bad, case])
    assert list(batch.unsolved) == [1]
    assert not batch[1].complete and numpy.isnan(batch[1].fmep) and "ring." in batch[1].reason
    pytest.importorskip("pandas")
    frame = batch.to_pandas()
    assert frame["reason"].tolist()[0] == "" and frame["reason"].tolist()[1] != ""
    assert frame["fmep"].isna().tolist() == [False, True, False]
    assert frame.attrs["units"]["fmep"] == "Pa"


def test_a_batch_refuses_what_a_run_refuses(case, slider):
    """Most of these would give numbers, of zeros that nobody stated."""
    cases = [case.copy() for _ in range(7)]
    for one, key in zip(
        cases, ("ring.face.crown_height", "contact.asperity_density", "contact.roughness", "engine.bore")
    ):
        del one[key]
    del cases[4]["lubricant.density"]
    cases[5]["gas.model"] = "wiebe"
    cases.insert(3, slider)
    batch = ringfilm.simulate_many(cases)
    assert sorted(batch.unsolved) == [0, 1, 2, 3, 4, 5, 6]
    assert "pad" in batch[3].reason and "engine.bore" in batch[4].reason and "lubricant.density" in batch[5].reason
    for i in (0, 1, 2, 4, 5, 6):
        assert not batch[i].complete and all(numpy.isnan(value) for value in batch[i].values.values())
        with pytest.raises(ringfilm.InputError):
            cases[i].run()
        with pytest.raises(ringfilm.InputError):
            cases[i].assumptions()
    assert batch[7].complete and batch[7].fmep == ringfilm.simulate_many([case])[0].fmep


def test_results_are_read_on_other_threads_without_a_word(folder):
    script = textwrap.dedent(
        """
        import concurrent.futures, ringfilm
        ringfilm.Case.read("case.toml").run().write("result.nc")
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(ringfilm.Result.read, ["result.nc"] * 2))
        """
    )
    done = subprocess.run([sys.executable, "-c", script], cwd=folder, capture_output=True, text=True, check=True)
    assert done.stdout + done.stderr == ""


def test_what_the_cases_raise_ends_the_batch(case):
    def failing():
        yield case
        raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        ringfilm.simulate_many(failing())
    with pytest.raises(TypeError, match="takes cases"):
        ringfilm.simulate_many([case, 3])
    with pytest.raises(ringfilm.InputError, match="threads"):
        ringfilm.simulate_many([case], threads=0)


def test_an_empty_batch():
    assert len(ringfilm.simulate_many([])) == 0


def test_import_is_quick_and_leaves_large_packages_alone():
    heavy = "('xarray', 'pandas', 'matplotlib', 'scipy')"
    script = f"import sys, ringfilm; print(' '.join(m for m in {heavy} if m in sys.modules))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, env=os.environ)
    assert done.stdout.strip() == ""


def test_python_m_ringfilm_is_the_program(folder, run_program):
    for words in (["run", "case.toml"], ["check", "nothing.toml"], ["run"], ["--version"], ["fields"]):
        program = run_program(*words)
        module = subprocess.run([sys.executable, "-m", "ringfilm", *words], cwd=folder, capture_output=True, text=True)
        assert (module.returncode, module.stdout, module.stderr) == (program.returncode, program.stdout, program.stderr)
    not_unicode = [b"check", b"\xff.toml"]
    program = subprocess.run([os.environ["RINGFILM_PROGRAM"], *not_unicode], capture_output=True)
    module = subprocess.run([sys.executable, "-m", "ringfilm", *not_unicode], capture_output=True)
    assert (module.returncode, module.stdout, module.stderr) == (2, program.stdout, program.stderr)
    assert pathlib.Path("case.toml").exists()
