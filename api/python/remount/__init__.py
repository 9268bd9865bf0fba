"""Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS.

    import remount
    result = remount.calibrate(remount.open("/data/drive1"))
    print(result)
    result.ins_from_lidar      # 4x4, m

Angles are radians, lengths metres, stamps nanoseconds of Unix time, but where a name says otherwise. A transform
a_from_b takes coordinates in frame b to frame a.
"""
from ._remount import (
    Estimate,
    Finding,
    Progress,
    Registration,
    Result,
    Session,
    Settings,
    SimulatedDrive,
    Stream,
    __version__,
    calibrate,
    drive_formats,
    export_formats,
    lidars_of,
    load_result,
    make_session,
    open,
    register,
    set_language,
    simulate,
    simulation_options,
    solve,
)
from .errors import Error

__all__ = [
    "Error", "Estimate", "Finding", "Progress", "Registration", "Result", "Session", "Settings", "SimulatedDrive",
    "Stream", "calibrate", "drive_formats", "export_formats", "lidars_of", "load_result", "make_session", "open",
    "register", "set_language", "simulate", "simulation_options", "solve",
]
