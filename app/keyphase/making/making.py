"""Making one demonstration: a family's script, a hand, sensors, and the truth of all of it."""

import zlib

import numpy as np
from scipy.signal import butter, sosfilt, sosfiltfilt
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.errors import MakingError
from keyphase.making import path as paths
from keyphase.making.contact import Change, Contact, levels, rings, rubbing, settled
from keyphase.making.draws import Array, Rows, chance, log_uniform
from keyphase.making.families import FAMILIES, SINGLE, Family
from keyphase.making.hand import Hand
from keyphase.making.made import TOLERANCE_S, Event, Made
from keyphase.making.sampling import Sampling
from keyphase.making.script import Script
from keyphase.making.sensing import Moving, estimated, wrist_sensor
from keyphase.making.truth import with_truth

RAMP_SHARE = 0.3
"""Share of a ramp within which its beginning (or, where contact is lost, its end) may be put."""


def make(family: str, seed: int) -> Made:
    """A demonstration of a family, with its truth; the same seed gives the same bytes.

    Families are those of `FAMILIES` and `SINGLE`. Raises MakingError for any other.
    """
    known = {**FAMILIES, **SINGLE}
    if family not in known:
        raise MakingError(f"Expected one of the families {', '.join(known)}, but got {family!r}.")
    rng = np.random.default_rng([zlib.crc32(family.encode()), seed])
    kind = known[family]
    hand, sampling = Hand.drawn(rng), Sampling.drawn(rng)
    script = Script(rng, hand, sampling.fine_hz)
    kind.write(script)
    ideal, rotation = script.path.poses()
    speed = paths.speed(ideal, rotation, sampling.fine_hz)
    motion = paths.motion_events(script.path.stretches, speed, sampling.fine_hz)
    has_wrench = chance(rng, kind.wrench)
    moving = Moving(*hand.unsteady(rng, ideal, rotation, sampling.fine_hz), sampling.fine_hz)
    settling = np.random.default_rng([zlib.crc32(family.encode()), seed, 1])
    wrench = _wrench(rng, settling, kind, script.contact, moving) if has_wrench else None
    stamps, pose_rows, wrench_rows = sampling.rows(rng, len(ideal))
    position = _measured_position(rng, moving)[pose_rows]
    turned = has_wrench or chance(rng, 0.4)
    with_torque = chance(rng, 0.85)
    demonstration = Demonstration(
        f"{family}_{seed}",
        stamps,
        position,
        _quaternions(moving.rotation, pose_rows) if turned and chance(rng, 0.95) else None,
        None if wrench is None else wrench[wrench_rows, :3],
        wrench[wrench_rows, 3:] if wrench is not None and with_torque else None,
    )
    changes = script.contact.changes if has_wrench else []
    contacts = [_contact_event(change) for change in changes if change.label is not None]
    return with_truth(family, demonstration, contacts, motion, script.reversals_s)


def _wrench(
    rng: np.random.Generator,
    settling: np.random.Generator,
    kind: Family,
    contact: Contact,
    moving: Moving,
) -> Array:
    time = np.arange(len(moving.position_m)) / moving.rate_hz
    level = levels(contact, time)
    touching = level + rubbing(rng, level, moving.velocity_m_s, moving.rate_hz)
    touching += rings(contact, time)
    touching += settled(settling, contact, time, kind.settles)
    sense = estimated if chance(rng, kind.estimated) else wrist_sensor
    return sense(rng, touching, moving, _least_newton(contact))


def _least_newton(contact: Contact) -> float:
    """The smallest step of force among the events; where nothing is touched, a usual one."""
    steps, before = [], np.zeros(6)
    for change in contact.changes:
        if change.label is not None:
            steps.append(float(np.linalg.norm((change.level - before)[:3])))
        before = change.level
    return max(min(steps), 0.2) if steps else 3.0


def _measured_position(rng: np.random.Generator, moving: Moving) -> Array:
    rate, position = moving.rate_hz, moving.position_m
    if chance(rng, 0.25):
        sos = butter(2, min(log_uniform(rng, 6.0, 20.0), 0.4 * rate), fs=rate, output="sos")
        position = np.asarray(sosfilt(sos, position - position[0], axis=0)) + position[0]
    elif chance(rng, 0.25):
        sos = butter(2, min(log_uniform(rng, 3.0, 12.0), 0.4 * rate), fs=rate, output="sos")
        position = np.asarray(sosfiltfilt(sos, position, axis=0))
    noise = log_uniform(rng, 1e-6, 2e-4)
    return position + rng.uniform(-0.5, 0.5, 3) + rng.normal(0.0, noise, position.shape)


def _quaternions(rotation: Rotation, rows: Rows) -> Array:
    return np.asarray(rotation.as_quat(scalar_first=True))[rows]


def _contact_event(change: Change) -> Event:
    more = RAMP_SHARE * change.rise_s
    label = change.label or ""
    if label == "contact lost":
        window = (TOLERANCE_S + more, TOLERANCE_S)
        return Event(change.time_s + change.rise_s, label, "contact", window)
    return Event(change.time_s, label, "contact", (TOLERANCE_S, TOLERANCE_S + more))
