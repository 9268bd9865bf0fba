"""The Python module: what it says of a drive whose truth is known, and that it neither hangs nor crashes."""
import ast
import os
import pickle
import re
import signal
import threading
import time

import numpy as np
import pytest

import remount

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
SAMPLE = os.path.join(SOURCE, "resources/sample")
QUICK = {"run.map_check": False}


def read(path):
    with open(os.path.join(SOURCE, path), encoding="utf-8") as file:
        return file.read()


def true_position_of_sample():
    numbers = re.search(r"translation_m: \[(.*?)\]", read("resources/sample/truth.yaml"))[1]
    return [float(number) for number in numbers.split(",")]


def turn(vector):
    """The rotation about a vector by its length (Rodrigues)."""
    angle = np.linalg.norm(vector)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def rigid(rotation_vector, translation):
    transform = np.eye(4)
    transform[:3, :3] = turn(np.asarray(rotation_vector, float))
    transform[:3, 3] = translation
    return transform


@pytest.fixture(scope="module")
def session():
    return remount.open(SAMPLE)


@pytest.fixture(scope="module")
def result(session):
    return remount.calibrate(session, settings=QUICK)


@pytest.fixture(scope="module")
def small_drive():
    return remount.simulate(scenario="figure-eight", duration_s=8.0, scan_rate_hz=5.0, beams=16, azimuth_steps=200,
                            moving_objects=0)


@pytest.fixture(scope="module")
def small_scans(small_drive):
    """Each is cast once, however often it is loaded."""
    return [small_drive.session.scan(scan) for scan in range(len(small_drive.session))]


def test_a_session_tells_what_it_has(session):
    sensors = {stream.sensor: stream for stream in session.sensors}
    assert sensors["lidar"].count == len(session) > 10
    keyframes = session.keyframes()
    assert len(keyframes) > 10 and np.all(np.diff(keyframes["stamp_ns"]) > 0)
    scan = session.scan(int(keyframes["scan"][0]))
    assert scan["points"].shape[1] == 3 and scan["points"].dtype == np.float32
    stamps_ns, local_from_ins = session.local_from_ins
    assert local_from_ins.shape == (len(stamps_ns), 4, 4)
    with pytest.raises(remount.Error, match="does not exist"):
        session.scan(len(session))


def test_the_sample_is_calibrated(result):
    off_m = result.ins_from_lidar[:3, 3] - true_position_of_sample()
    sigma = np.sqrt(np.diag(result.covariance))
    print("off by", off_m, "m, sigma", sigma)
    assert result.status == "ok" and result.usable
    assert np.all(np.abs(off_m) < 4 * sigma[:3])
    assert np.allclose(result.covariance, result.covariance.T)
    assert result.estimates["yaw"].observed and result.estimates["x"].sigma == pytest.approx(sigma[0])


def test_pairs_hold_the_motions_and_their_residuals(result):
    accepted = result.pairs[result.pairs["state"] == "accepted"]
    x = result.ins_from_lidar
    predicted = np.linalg.inv(x) @ accepted["ins_b_from_ins_a"] @ x
    by_hand_m = np.linalg.norm(predicted[:, :3, 3] - accepted["lidar_b_from_lidar_a"][:, :3, 3], axis=1)
    assert len(accepted) > 10
    assert np.allclose(by_hand_m, np.linalg.norm(accepted["residual"][:, :3], axis=1), atol=1e-9)
    assert np.array_equal(result.residuals, accepted["residual"])


def test_results_are_saved_and_exported(result, tmp_path):
    result.save(tmp_path / "result.yaml")
    loaded = remount.load_result(tmp_path / "result.yaml")
    assert np.allclose(loaded.ins_from_lidar, result.ins_from_lidar, atol=1e-9)
    assert len(loaded.pairs) == len(result.pairs) and np.isnan(loaded.pairs["ins_b_from_ins_a"]).all()
    for name in remount.export_formats():
        if name not in ("beams", "apollo-rfu"):
            assert result.export(name), name
    assert "mine" in result.export("ros2", lidar_frame="mine")
    with pytest.raises(remount.Error) as raised:
        result.export("nothing")
    assert raised.value.code == "contract"


def test_errors_have_code_place_and_expectation(tmp_path):
    missing = str(tmp_path / "nowhere")
    with pytest.raises(remount.Error) as raised:
        remount.open(missing)
    assert (raised.value.code, raised.value.place) == ("io", missing)
    assert raised.value.expectation and str(raised.value) == f"{missing}: {raised.value.expectation}"
    copy = pickle.loads(pickle.dumps(raised.value))
    assert (copy.code, str(copy)) == ("io", str(raised.value))
    with pytest.raises(remount.Error):
        remount.calibrate([])
    with pytest.raises(TypeError):
        remount.calibrate(missing)
    with pytest.raises(remount.Error, match="no rotation"):
        remount.solve(np.zeros((3, 4, 4)) + np.diag([2, 2, 2, 1.0]), np.zeros((3, 4, 4)) + np.eye(4))


def test_settings_are_checked():
    settings = remount.Settings({"pairing.max_gap_s": 2.5})
    assert settings["pairing.max_gap_s"] == 2.5 and settings["run.map_check"] is True
    settings["keyframes.minimum"] = 50
    assert settings["keyframes.minimum"] == 50 and remount.Settings()["keyframes.minimum"] != 50
    for name, value in (("pairing.max_gap_s", -1.0), ("pairing.no_such", 1), ("run.method", "none")):
        with pytest.raises(remount.Error):
            settings[name] = value
    described = {option["name"]: option for option in settings.all()}
    assert described["pairing.max_gap_s"]["unit"] == "s" and "pairwise" in described["run.method"]["choices"]


def test_p_and_q_are_solved():
    random = np.random.default_rng(1)
    x = rigid([0.02, -0.03, 0.4], [1.2, -0.3, 0.8])
    p = np.array([rigid(random.normal(0, 0.3, 3), random.normal(0, 2, 3)) for _ in range(40)])
    q = np.linalg.inv(x) @ p @ x
    solved = remount.solve(p, q)
    print("off by", np.abs(solved.ins_from_lidar - x).max())
    assert solved.status == "ok" and np.allclose(solved.ins_from_lidar, x, atol=1e-6)
    with pytest.raises(remount.Error):
        remount.solve(p, q[:-1])


def test_scans_are_registered(session):
    points = session.scan(0)["points"]
    moved = rigid([0.0, 0.0, 0.05], [0.4, -0.2, 0.0])
    inverse = np.linalg.inv(moved)
    found = remount.register(points, points @ inverse[:3, :3].T + inverse[:3, 3])
    print("off by", np.abs(found.target_from_source - inverse).max(), found)
    assert found.converged and not found.failure
    assert np.allclose(found.target_from_source, inverse, atol=0.01)
    with pytest.raises(remount.Error, match="n, 3"):
        remount.register(points[:, :2], points)


def test_a_reader_of_ones_own_is_calibrated(small_drive, small_scans):
    recorded = small_drive.session
    stamps_ns, poses = recorded.local_from_ins
    loaded = []

    def load(scan):
        if scan == 20:
            raise ValueError("of the loader")
        loaded.append(scan)
        return small_scans[scan]

    own = remount.make_session("mine", world_from_ins=(stamps_ns, poses), scan_times="per_point", load_scan=load,
                               scan_stamps_ns=[recorded.scan_stamp_ns(scan) for scan in range(len(recorded))])
    result = remount.calibrate(own, settings=QUICK)
    off_m = (result.ins_from_lidar - small_drive.ins_from_lidar)[:2, 3]
    print(len(loaded), "scans loaded, off by", off_m)
    assert result.usable and len(loaded) > 10 and np.linalg.norm(off_m) < 0.15
    assert any("of the loader" in finding.explanation for finding in result.findings), result.findings
    with pytest.raises(remount.Error, match="ascend"):
        remount.make_session("mine", world_from_ins=(stamps_ns[::-1], poses), load_scan=load, scan_stamps_ns=[0, 1])


def quaternion_xyzw(rotation):
    """Of a rotation by less than half a turn about whatever axis."""
    w = np.sqrt(max(0.0, 1 + np.trace(rotation))) / 2
    axis = [rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]
    return np.append(np.asarray(axis) / (4 * w), w)


def test_geodetic_samples_of_ones_own_are_calibrated(small_drive, small_scans):
    recorded = small_drive.session
    stamps_ns, enu_from_ins = recorded.local_from_ins
    latitude, a, e2 = np.radians(48.78), 6378137.0, 6.69437999014e-3  # WGS 84
    curved = 1 - e2 * np.sin(latitude) ** 2
    north_m, east_m = a * (1 - e2) / curved**1.5, a / np.sqrt(curved) * np.cos(latitude)
    east, north, up = enu_from_ins[:, :3, 3].T
    positions = np.column_stack((latitude + north / north_m, np.radians(9.18) + east / east_m, up))
    attitudes = np.array([quaternion_xyzw(pose[:3, :3]) for pose in enu_from_ins])
    told = np.isfinite(attitudes).all(axis=1)
    own = remount.make_session("mine", ins=(stamps_ns[told], positions[told], attitudes[told]), scan_times="per_point",
                               load_scan=small_scans.__getitem__,
                               scan_stamps_ns=[recorded.scan_stamp_ns(scan) for scan in range(len(recorded))])
    result = remount.calibrate(own, settings=QUICK)
    off_m = (result.ins_from_lidar - small_drive.ins_from_lidar)[:2, 3]
    print("off by", off_m)
    assert result.usable and np.linalg.norm(off_m) < 0.15
    for wrong in ((stamps_ns, positions[:-1], attitudes), (stamps_ns, np.degrees(positions), attitudes)):
        with pytest.raises(remount.Error, match="expected"):
            remount.make_session("mine", ins=wrong, load_scan=small_scans.__getitem__, scan_stamps_ns=[0, 1])


def test_progress_is_told_and_cancels(small_drive):
    told = []
    remount.calibrate(small_drive.session, settings=QUICK, progress=lambda *step: told.append(step))
    assert len({stage for stage, done, total in told}) > 2 and all(isinstance(done, int) for _, done, _ in told)

    progress = remount.Progress(lambda *step: progress.cancel())
    assert remount.calibrate(small_drive.session, settings=QUICK, progress=progress).status == "cancelled"
    assert progress.cancelled

    def fail(*step):
        raise KeyError("of the callback")

    with pytest.raises(KeyError, match="of the callback"):
        remount.calibrate(small_drive.session, settings=QUICK, progress=fail)


def test_other_threads_run_meanwhile_and_an_interrupt_ends_the_call(session):
    ticks, done = [], threading.Event()

    def tick():
        while not done.wait(0.01):
            ticks.append(time.monotonic())
            if len(ticks) == 20:
                os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=tick)
    thread.start()
    begun = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            remount.calibrate(session, settings=QUICK)
    finally:
        took_s = time.monotonic() - begun
        done.set()
        thread.join()
    print(len(ticks), "ticks in", took_s, "s")
    assert len(ticks) >= 20


def test_drives_are_written(small_drive, tmp_path):
    few = remount.simulate(duration_s=1.0, beams=4, azimuth_steps=32)
    few.write(tmp_path / "drive")
    assert len(remount.open(tmp_path / "drive")) == len(few.session)
    assert "native" in remount.drive_formats()
    with pytest.raises(remount.Error):
        remount.simulate(no_such_option=1)


def test_everything_is_said_in_chinese_as_well(result):
    remount.set_language("zh_CN")
    try:
        assert any(ord(sign) > 0x2E80 for sign in result.message)
    finally:
        remount.set_language("en")
    assert result.message.isascii()


def test_objects_show_themselves_shortly(session, result, small_drive):
    for value in (session, result, small_drive, result.estimates["x"], remount.Settings(), remount.Progress()):
        print(repr(value))
        assert len(repr(value)) < 400 and "object at" not in repr(value)


def test_stubs_have_what_the_module_has():
    stubs = ast.parse(read("api/python/remount/__init__.pyi"))
    named = {node.name: node for node in stubs.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(remount.__all__) - {"Error"} == set(named)
    for name, node in named.items():
        if isinstance(node, ast.ClassDef):
            members = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            there = {member for member in vars(getattr(remount, name)) if not member.startswith("_")}
            assert there == {member for member in members if not member.startswith("_")}, name


def test_the_lines_of_the_page_plot_the_residuals(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    block = re.search(r"```python\n(.*?)```", read("docs/python.md"), re.DOTALL)[1]
    assert len(block.strip().split("\n")) == 5
    monkeypatch.chdir(tmp_path)
    exec(block.replace("/usr/share/remount/sample", SAMPLE), {})
    assert os.path.getsize("residuals.png") > 5000
