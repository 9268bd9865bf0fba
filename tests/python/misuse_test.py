"""What is given wrongly is answered by an error that names it, and never ends Python or hangs."""
import copy
import os
import pickle

import numpy as np
import pytest

import remount
from remount_test import QUICK, SAMPLE


@pytest.fixture(scope="module")
def sample():
    return remount.open(SAMPLE)


def own_session(sample, load, **given):
    given.setdefault("scan_stamps_ns", [sample.scan_stamp_ns(i) for i in range(len(sample))])
    return remount.make_session("own", world_from_ins=sample.local_from_ins, load_scan=load, **given)


def refusal(call, *arguments, **named):
    with pytest.raises(remount.Error) as raised:
        call(*arguments, **named)
    return raised.value


def test_what_a_callback_raises_is_raised_once(sample):
    def fail(*_):
        raise KeyError("mine")

    progress = remount.Progress(fail)
    with pytest.raises(KeyError):
        remount.calibrate(sample, settings=QUICK, progress=progress)
    assert remount.calibrate(sample, settings=QUICK, progress=progress).status == "cancelled"


def test_a_progress_is_refused_within_its_own_callback(sample):
    refused = []

    def call_again(*_):
        if not refused:
            refused.append(refusal(remount.calibrate, sample, settings=QUICK, progress=progress))

    progress = remount.Progress(call_again)
    assert remount.calibrate(sample, settings=QUICK, progress=progress).status == "ok"
    assert refused[0].code == "contract"


def test_nothing_is_opened_or_written_by_halves(sample, tmp_path):
    cancelled = remount.Progress()
    cancelled.cancel()
    assert refusal(remount.open, SAMPLE, progress=cancelled).code == "cancelled"
    assert refusal(remount.lidars_of, SAMPLE, progress=cancelled).code == "cancelled"
    drive = remount.simulate(duration_s=2, beams=16, azimuth_steps=90)
    progress = remount.Progress(lambda stage, done, total: progress.cancel() if done >= 3 else None)
    assert refusal(drive.write, tmp_path / "drive", progress=progress).code == "cancelled"
    assert os.listdir(tmp_path / "drive") == []
    drive.write(tmp_path / "drive")
    assert len(remount.open(tmp_path / "drive")) > 0


def test_scans_that_promise_times_have_them(sample):
    points = [sample.scan(i)["points"] for i in range(len(sample))]
    error = refusal(own_session, sample, points.__getitem__, scan_times="per_point")
    assert (error.code, error.place) == ("format", "0")
    assert own_session(sample, points.__getitem__, scan_times="unknown").path is None


def test_errors_of_a_loader_keep_what_they_say(sample):
    def own_error(_):
        raise remount.Error("format", "f.pcd:7", "no header")

    def other_error(_):
        raise ValueError("bad")

    error = refusal(own_session(sample, own_error).scan, 0)
    assert (error.code, error.place, error.expectation) == ("format", "f.pcd:7", "no header")
    assert refusal(own_session(sample, other_error).scan, 0).expectation == "ValueError: bad"


@pytest.mark.parametrize("ring", [np.full(3, 70000), np.full(3, -1), np.zeros((3, 1))])
def test_columns_hold_what_they_can(sample, ring):
    session = own_session(sample, lambda _: {"points": np.ones((3, 3)), "ring": ring})
    error = refusal(session.scan, 0)
    assert error.code == "contract" and error.place == "0: ring"


@pytest.mark.parametrize("stamps", [[0.1, 0.2], ["a", "b"], [[1], [2]]])
def test_stamps_are_whole_nanoseconds(sample, stamps):
    assert "nanoseconds" in refusal(own_session, sample, lambda _: None, scan_stamps_ns=np.array(stamps)).expectation


def test_settings_name_what_is_wrong(sample):
    for wrong in ({"pairing.max_gp_s": 2}, {"pairing.max_gap_s": -1}, {"run.map_check": None}, {"pairing.max_gap_s": 2**70}):
        assert next(iter(wrong)) in str(refusal(remount.calibrate, sample, settings=wrong))
    with pytest.raises(TypeError, match="Settings"):
        remount.calibrate(sample, settings=5)


def test_settings_are_a_mapping_that_can_be_copied():
    settings = remount.Settings({"pairing.max_gap_s": np.float32(2.5), "run.map_check": np.bool_(False)})
    assert "pairing.max_gap_s" in settings and "nowhere" not in settings
    assert len(settings) == len(list(settings)) == len(dict(settings))
    for other in (pickle.loads(pickle.dumps(settings)), copy.copy(settings), remount.Settings(dict(settings))):
        assert other["pairing.max_gap_s"] == 2.5 and other["run.map_check"] is False


def test_a_path_that_is_no_text_is_named():
    name = os.fsdecode(b"nowhere\xff")
    for read in (remount.open, remount.load_result, remount.Settings.load):
        assert refusal(read, name).place == name


def test_points_that_no_lidar_sees_are_refused(sample):
    assert refusal(remount.register, np.full((1000, 3), 5e6), sample.scan(0)).place == "source"


def test_pairs_of_one_moment_are_refused():
    still = np.tile(np.eye(4), (5, 1, 1))
    error = refusal(remount.solve, still, still, a=range(5), b=range(5))
    assert error.place == "pairs[0]"


def test_arguments_of_the_wrong_kind_are_named(sample):
    for wrong in ([sample, None], 5):
        with pytest.raises(TypeError, match="expected a Session or a list of them"):
            remount.calibrate(wrong)
    assert refusal(remount.calibrate, sample, threads=-1).place == "threads"
    assert refusal(remount.simulate, beams=0).place == "options"
    assert refusal(remount.simulate, ins_rate_hz=[1]).place == "ins_rate_hz"
