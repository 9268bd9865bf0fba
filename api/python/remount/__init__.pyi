from os import PathLike
from typing import Any, Callable, Dict, ItemsView, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import Error as Error

__version__: str

_Path = Union[str, "PathLike[str]"]
_Value = Union[bool, int, float, str]
_Stamped = Tuple[ArrayLike, ArrayLike]  # stamps in ns, (n,), and transforms, (n, 4, 4)
_Scan = Union[ArrayLike, Mapping[str, Any]]
_Told = Union["Progress", Callable[[str, int, int], object], None]

class Progress:
    """Of a long call: hears of it, and cancels it, from any thread. What the callback raises cancels it as well. One that
    was cancelled stays so, and calls within the callback need one of their own."""

    def __init__(self, callback: Optional[Callable[[str, int, int], object]] = None) -> None: ...
    def cancel(self) -> None: ...
    @property
    def cancelled(self) -> bool: ...

class Settings:
    """All settings of a calibration, by their names in files: settings["pairing.max_gap_s"] = 2.5."""

    def __init__(self, values: Mapping[str, _Value] = ...) -> None: ...
    @staticmethod
    def load(path: _Path) -> Settings: ...
    def __getitem__(self, name: str) -> _Value: ...
    def __setitem__(self, name: str, value: _Value) -> None: ...
    def __contains__(self, name: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def keys(self) -> List[str]: ...
    def items(self) -> ItemsView[str, _Value]: ...
    def all(self) -> List[Dict[str, Any]]:
        """Of each: name, value, unit, meaning, minimum, maximum, choices."""
    def text(self) -> str:
        """A configuration file, with comments."""

_Settings = Union[Settings, Mapping[str, _Value], None]

class Finding:
    """What is suspicious about data or a result."""

    @property
    def severity(self) -> str: ...
    @property
    def code(self) -> str: ...
    @property
    def place(self) -> str: ...
    @property
    def explanation(self) -> str: ...

class Stream:
    """What one sensor recorded."""

    @property
    def sensor(self) -> str: ...
    @property
    def count(self) -> int: ...
    @property
    def first_ns(self) -> int: ...
    @property
    def last_ns(self) -> int: ...
    @property
    def rate_hz(self) -> float: ...
    @property
    def gaps(self) -> int: ...
    @property
    def longest_gap_s(self) -> float: ...

class Session:
    """A recorded drive. Its length is the number of its scans."""

    @property
    def name(self) -> str: ...
    @property
    def path(self) -> Optional[PathLike[str]]:
        """None where it was not opened from files."""
    @property
    def format(self) -> str: ...
    @property
    def lidar(self) -> str: ...
    @property
    def nominal_ins_from_lidar(self) -> Optional[NDArray[np.float64]]: ...
    @property
    def sensors(self) -> List[Stream]: ...
    @property
    def findings(self) -> List[Finding]: ...
    @property
    def local_from_ins(self) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Stamps in ns, and transforms (n, 4, 4) to a metric frame."""
    def keyframes(self, settings: _Settings = None) -> NDArray[np.void]:
        """The scans that a calibration would begin with: scan, stamp_ns, travelled_m."""
    def scan(self, scan: int) -> Dict[str, Any]:
        """points (n, 3) in m; time_from_stamp_s, intensity and ring, or None."""
    def scan_stamp_ns(self, scan: int) -> int: ...
    def __len__(self) -> int: ...

class Estimate:
    """One parameter, m or rad. What is not observed has no sigma, and says why."""

    @property
    def value(self) -> float: ...
    @property
    def sigma(self) -> Optional[float]: ...
    @property
    def observed(self) -> bool: ...
    @property
    def measured(self) -> bool: ...
    @property
    def why_not_observed(self) -> str: ...

class Result:
    """What a calibration found, and how sure it is."""

    @property
    def status(self) -> str:
        """"ok", "degenerate", "too_few_pairs", "too_little_data", "no_usable_data", "not_converged", "out_of_range",
        "inconsistent" or "cancelled"."""
    @property
    def message(self) -> str: ...
    @property
    def advice(self) -> List[str]: ...
    @property
    def usable(self) -> bool: ...
    @property
    def method(self) -> str: ...
    @property
    def ins_from_lidar(self) -> NDArray[np.float64]:
        """X, (4, 4), m. Raises Error where the method finds the LiDAR in another frame: reference_from_sensor."""
    @property
    def reference_from_sensor(self) -> NDArray[np.float64]: ...
    @property
    def reference_frame(self) -> str: ...
    @property
    def sensor_frame(self) -> str: ...
    @property
    def covariance(self) -> NDArray[np.float64]:
        """(6, 6) of x, y, z, yaw, pitch, roll, m and rad; NaN in rows and columns of what is not observed."""
    @property
    def estimates(self) -> Dict[str, Estimate]:
        """Of "x", "y", "z", "yaw", "pitch", "roll"."""
    @property
    def pairs(self) -> NDArray[np.void]:
        """session, stamp_a_ns, stamp_b_ns, state, reason, rotation_rad, baseline_m, rmse_m, overlap,
        residual_rotation_rad, residual_translation_m, weight, ins_b_from_ins_a, lidar_b_from_lidar_a, residual."""
    @property
    def residuals(self) -> NDArray[np.float64]:
        """(n, 6) of the accepted pairs: translation (m), rotation vector (rad); NaN in a result of a file."""
    @property
    def rotation_rms_rad(self) -> float: ...
    @property
    def translation_rms_m(self) -> float: ...
    @property
    def time_offset_s(self) -> float:
        """t_ins = t_lidar + offset; NaN where not estimated."""
    @property
    def time_offset_sigma_s(self) -> float: ...
    @property
    def findings(self) -> List[Finding]: ...
    @property
    def settings(self) -> Settings: ...
    def save(self, path: _Path) -> None: ...
    def export(self, format: str, *, ins_frame: str = "", lidar_frame: str = "") -> str: ...
    @property
    def export_warnings(self) -> List[str]: ...

class Registration:
    """The motion between two scans."""

    @property
    def target_from_source(self) -> NDArray[np.float64]: ...
    @property
    def converged(self) -> bool: ...
    @property
    def iterations(self) -> int: ...
    @property
    def rmse_m(self) -> float: ...
    @property
    def overlap(self) -> float: ...
    @property
    def information(self) -> NDArray[np.float64]:
        """Inverse covariance of translation (m) and rotation vector (rad), in the axes of the target."""
    @property
    def failure(self) -> str: ...
    @property
    def undetermined(self) -> str: ...

class SimulatedDrive:
    """A drive with known truth."""

    @property
    def session(self) -> Session: ...
    @property
    def ins_from_lidar(self) -> NDArray[np.float64]: ...
    @property
    def enu_from_ins(self) -> Tuple[NDArray[np.int64], NDArray[np.float64]]: ...
    def write(self, folder: _Path, format: str = "native", progress: _Told = None) -> None: ...

def open(path: _Path, *, lidar: str = "", topics: Mapping[str, str] = ..., progress: _Told = None) -> Session:
    """A recording of whatever format, recognised by its content."""

def lidars_of(path: _Path, *, progress: _Told = None) -> List[str]: ...

def make_session(
    name: str,
    *,
    ins: Optional[Tuple[ArrayLike, ArrayLike, ArrayLike]] = None,
    world_from_ins: Optional[_Stamped] = None,
    scan_stamps_ns: Sequence[int] = ...,
    load_scan: Optional[Callable[[int], _Scan]] = None,
    scan_times: str = "at_stamp",
    odometry_from_lidar: Optional[_Stamped] = None,
    nominal_ins_from_lidar: Optional[ArrayLike] = None,
    progress: _Told = None,
) -> Session:
    """What a reader of your own has read.

    The motion of the INS is either ins: stamps (n,), positions (n, 3) as latitude and longitude in rad and height above
    the ellipsoid in m, and quaternions (n, 4) x, y, z, w of enu_from_ins, whose INS axes are forward, left, up; or poses
    in a metric world. That of the LiDAR comes from scans or from the poses of an odometry. scan_times is "at_stamp",
    "per_point" or "unknown".
    """

def calibrate(
    sessions: Union[Session, Sequence[Session]],
    *,
    settings: _Settings = None,
    nominal_ins_from_lidar: Optional[ArrayLike] = None,
    ignore_declared_nominal: bool = False,
    hash_inputs: bool = True,
    threads: int = 0,
    progress: _Told = None,
) -> Result:
    """Finds the mounting of the LiDAR from sessions of one vehicle."""

def solve(
    ins_b_from_ins_a: ArrayLike,
    lidar_b_from_lidar_a: ArrayLike,
    *,
    a: Optional[Sequence[int]] = None,
    b: Optional[Sequence[int]] = None,
    settings: _Settings = None,
    nominal_ins_from_lidar: Optional[ArrayLike] = None,
    threads: int = 0,
    progress: _Told = None,
) -> Result:
    """Solves P X = X Q from arrays of (n, 4, 4). a and b number the moments that pairs have in common."""

def load_result(path: _Path) -> Result: ...
def export_formats() -> Dict[str, str]: ...

def register(
    source: _Scan,
    target: _Scan,
    *,
    target_from_source_start: Optional[ArrayLike] = None,
    settings: _Settings = None,
    progress: _Told = None,
) -> Registration:
    """Aligns two scans, arrays of (n, 3) in m."""

def simulate(*, ins_from_lidar: Optional[ArrayLike] = None, **options: _Value) -> SimulatedDrive:
    """Options are those of simulation_options(): simulate(scenario="figure-eight", duration_s=10.0)."""

def simulation_options() -> List[Dict[str, Any]]: ...
def drive_formats() -> List[str]: ...
def set_language(language: str) -> None:
    """"en" or "zh_CN": of all that is said from now on."""
