"""Execute a skill file (version 2) on any robot, with numpy and json alone: copy and adapt.

plan = Plan("setup1.skills.json", sensed)          sensed = position (3,), orientation w x y z (4,),
while plan.stage != "over":                                 velocity (6,), force on the tool (3,)
    robot.follow(*plan.reference)                  position, orientation, velocity (6,) for 4 ms
    plan.step(sensed)                              plan.outcomes says how each skill ended
"""

import json

import numpy as np


def times(a, b):
    w, v, x, u = a[0], a[1:], b[0], b[1:]
    return np.array([w * x - v @ u, *(w * u + x * v + np.cross(v, u))])


def turn(to, origin, shortest=False):
    q = times(to, origin * [1, -1, -1, -1])
    q = -q if shortest and q[0] < 0 else q
    sine = np.linalg.norm(q[1:])
    return 2 * np.arctan2(sine, q[0]) / (sine + 1e-300) * q[1:]


def turned(q, v):
    half = np.linalg.norm(v) / 2
    q = times(np.array([np.cos(half), *(np.sin(half) / (2 * half + 1e-300) * v)]), q)
    return q / np.linalg.norm(q)


def within(v, reach):
    far = np.linalg.norm(v) > reach
    return (v * reach / np.linalg.norm(v) if far else v), far


def eased(share):
    return 0.5 - 0.5 * np.cos(np.pi * share)


def stroke_of(squaring, aside, q, time):
    """How far a part that is squared is lifted and moved from side to side by now."""
    stroke, d = time / squaring["stroke_s"] - 1, np.array(squaring["normal"])
    lift = -squaring["lift_m"] * eased(max(min(stroke + 1, 9 - stroke, 1), 0)) * d
    lift = lift + eased(max(min(stroke + 1, 1), 0)) * aside
    if not 0 < stroke < 8:
        return lift
    axes = [times(times(q, np.r_[0, e]), q * [1, -1, -1, -1])[1:] for e in np.eye(3)[:2]]
    along = min(axes, key=lambda axis: abs(axis @ d))
    along = along - along @ d * d
    along = along / np.linalg.norm(along)
    beside = np.cross(d, along)
    if stroke >= 4:
        along, beside, stroke = beside, along, stroke - 4
    fade = eased(min(2 * stroke, 2 * (4 - stroke), 1))
    shake = fade * squaring["shake_m"] * np.sin(2 * np.pi * squaring["shake_hz"] * time)
    places = 0, squaring["reach_m"], -squaring["reach_m"], squaring["last_m"], 0
    i = int(stroke)
    place = places[i] + eased(stroke - i) * (places[i + 1] - places[i])
    return lift + place * along + shake * beside


def kept_at(skill, fraction, touching=True, felt=None, firmer=1.0, below=1.0):
    """Directions and forces to press with at a fraction of the demonstrated time."""
    for kept in skill["kept"]:
        place = min(max(fraction, 0.0), 1.0) * (len(kept["force_N"]) - 1)
        if (kept["met"] or touching) and kept["force_N"][int(place + 0.5)] > 0:
            force = np.interp(place, np.arange(len(kept["force_N"])), kept["force_N"])
            d = np.array(kept["direction"][int(place + 0.5)])
            if felt is not None and kept["carries"]:
                drags = np.linalg.norm(felt - felt @ d * d)
                left = np.sqrt(max((below * skill["force_limit_N"]) ** 2 - drags**2, 0))
                force = max(force, min(drags / kept["carries"], firmer * force, left))
            yield d, force


def pushed_at(skill, fraction):
    """What is exerted besides, at a fraction of the demonstrated time."""
    pushed = np.zeros(3)
    for kept in skill["kept"]:
        if rows := kept.get("pushed_N"):
            place = min(max(fraction, 0.0), 1.0) * (len(rows) - 1)
            before, after = (
                np.array(rows[int(place)]),
                np.array(rows[min(int(place) + 1, len(rows) - 1)]),
            )
            pushed = pushed + before + (place - int(place)) * (after - before)
    return pushed


class Plan:
    def __init__(self, file, sensed):
        with open(file, encoding="utf-8") as text:
            self.file = json.load(text)
        self.e, self.skills = self.file["execution"], self.file["skills"]
        self.h, self.shift, self.outcomes, self.sensed = self.e["step_s"], np.zeros(3), [], sensed
        self.reference, self.rotated = (*sensed[:2], np.zeros(6)), np.array([1.0, 0, 0, 0])
        self.begin(np.zeros(6))
        self.reference = self.follow()

    def step(self, sensed):
        self.sensed, self.in_stage = sensed, self.in_stage + self.h
        time, e = self.in_stage + 1e-9, self.e
        self.touch()
        if self.stage == "moving":
            outcome = self.outcome(self.skill)
            if outcome == "contact" and self.skill["press"]:
                press = self.skill["press"]
                firmly = max(press["force_N"], self.seat["press_N"] if self.seat else 0.0)
                self.pressed = [*self.kept(1.0), (np.array(press["direction"]), firmly)]
                self.enter("pressing")
            elif outcome:
                self.end(outcome, self.velocity)
        elif self.stage == "pressing":
            still = np.linalg.norm(sensed[2][:3]) < e["still_m_s"]
            pressed = time >= e["pressed_most_s"] or (time >= e["pressed_least_s"] and still)
            if time >= e["seating_s"] if self.seat else pressed:
                if self.is_in():
                    self.end("contact", np.zeros(6))
                else:
                    self.yielded, self.strokes_from = np.zeros(3), sensed[0]
                    if self.skill["squaring"]:
                        off = self.skill["end_position_m"] + self.shift - sensed[0]
                        self.aside = off - off @ (n := np.array(self.seat["normal"])) * n
                    self.enter("searching")
        elif self.stage == "searching" and self.is_in():
            self.reference, self.searched = (*self.sensed[:2], np.zeros(6)), True
            self.enter("pressing")
        elif self.stage == "searching" and self.skill["search"] and time >= self.seat["duration_s"]:
            self.end("timeout", np.zeros(6))
        elif self.stage == "loading" and (time >= e["pressed_most_s"] or self.loaded()):
            self.move(np.zeros(6))
        elif self.stage == "resting" and time >= e["rest_s"]:
            self.stage = "over"
        self.reference = self.follow()

    def kept(self, fraction, dragged=None):
        felt, e = self.sensed[3] if dragged is None else dragged, self.e
        firmer, below = e["gripped_firmer"], e["gripped_below"]
        return list(kept_at(self.skill, fraction, self.touching(), felt, firmer, below))

    def touching(self):
        return np.linalg.norm(self.sensed[3]) > self.e["touching_N"]

    def enter(self, stage):
        self.stage, self.in_stage, self.still = stage, 0.0, (*self.reference[:2], np.zeros(6))

    def touch(self):
        """Where the tool first touched what it is to go into, and whether it fell into it."""
        if search := self.skill["search"]:
            d, (at, _, _, force), e = (
                np.array(self.skill["press"]["direction"]),
                self.sensed,
                self.e,
            )
            self.felt += e["touch_smoothed"] * (-force @ d - self.felt)
            lasts = self.stage != "moving" and self.places
            if self.felt - self.free < e["touch_N"] and not lasts:
                self.places, self.fell = [], False
                return
            self.places.append(at @ d)
            recent = self.places[-max(1, round(e["seat_fall_s"] / self.h)) :]
            self.fell |= at @ d - min(recent) >= e["seat_fall"] * search["depth_m"]

    def is_in(self):
        if not self.seat:
            return True
        if self.skill["squaring"]:
            return self.squared >= 10 * self.seat["stroke_s"]
        place = self.sensed[0] @ np.array(self.skill["press"]["direction"])
        deep = place - min(self.places, default=place)
        least = 1.0 if self.fell else self.e["seat_crept"]
        return deep >= least * self.skill["search"]["depth_m"]

    def seek(self, position, orientation, velocity):
        """A reference that the seat can turn, and that circles outwards during a search."""
        q, search, h = self.sensed[1], self.skill["search"], self.h
        d = np.array(self.skill["press"]["direction"])
        if self.stage == "searching" and not search:
            self.squared = self.in_stage
            away = stroke_of(self.seat, self.aside, orientation, self.squared)
            then = stroke_of(self.seat, self.aside, orientation, self.squared + h)
            return self.strokes_from + away, orientation, np.r_[(then - away) / h, 0, 0, 0]
        tips = search and not (self.stage == "pressing" and self.fell)
        easily = self.e["seat_turning" if tips else "squared_turning"]
        orientation = turned(q, easily * turn(orientation, q, True))
        first = np.cross(d, np.eye(3)[np.abs(d).argmin()])
        first = first / np.linalg.norm(first)
        if self.stage == "pressing":
            t, e = self.in_stage, self.e
            left = max(0.0, e["seating_s"] - e["rocking_calm_s"] - t)
            share = min(1.0, t / e["rocking_faded_s"], left / e["rocking_faded_s"])
            a = 2 * np.pi * e["rocking_hz"] * t
            axis = np.cos(a) * first + np.sin(a) * np.cross(d, first)
            orientation = turned(orientation, share * e["rocking_rad"] * axis)
            off = position - self.sensed[0]
            along = off @ d * d
            position = self.sensed[0] + along + self.e["seat_giving"] * (off - along)
        else:
            done = min(2 * self.in_stage / search["duration_s"], 2.0)
            share = (1 - abs(1 - done)) ** 0.5
            angle = 2 * np.pi * search["turns"] * (share if done < 1 else 2 - share)
            aside = np.cos(angle) * first + np.sin(angle) * np.cross(d, first)
            position = position + search["radius_m"] * share * aside - self.yielded
            off, felt = (v - v @ d * d for v in (position - self.sensed[0], self.sensed[3]))
            size, most = np.linalg.norm(felt), self.e["seat_yields"] * search["press_N"]
            if size > most:
                beyond = (1 - most / size) * off
                position, self.yielded = position - beyond, self.yielded + beyond
        return position, orientation, velocity

    def begin(self, velocity):
        self.skill, self.searched = self.skills[len(self.outcomes)], False
        if self.skill["connecting"]:
            self.shift, self.rotated = 0 * self.shift, np.array([1.0, 0, 0, 0])
        self.seat, self.squared = self.skill["search"] or self.skill["squaring"], 0.0
        if self.skill["search"]:
            self.places, self.fell = [], False
            self.felt = self.free = -self.sensed[3] @ np.array(self.skill["press"]["direction"])
        self.pressed = list(kept_at(self.skill, 0.0))
        self.enter("loading") if not self.loaded() else self.move(velocity)

    def loaded(self):
        e, force = self.e, self.sensed[3]
        least = [max(e["loaded_within"] * f, e["loaded_within_N"]) for _, f in self.pressed]
        return all(abs(f + force @ d) <= w for (d, f), w in zip(self.pressed, least, strict=True))

    def move(self, velocity):
        skill, (y, q, _, force) = self.skill, self.sensed
        p, c, needs = skill["primitive"], skill["primitive"]["constants"], skill["precondition"]
        start_q, self.tau0 = np.array(p["start_orientation_wxyz"]), p["duration_s"] / 3
        q = q if q @ start_q >= 0 else -q
        self.goal = np.array(p["goal_position_m"]) + self.shift
        self.goal_q = q
        if p["oriented"]:
            near = np.array(p["goal_orientation_wxyz"])
            self.goal_q = times(self.rotated, near)
            self.goal_q = self.goal_q if self.goal_q @ near >= 0 else -self.goal_q
        left = np.r_[self.goal - y, turn(self.goal_q, q)]
        shown = np.subtract(p["goal_position_m"], p["start_position_m"])
        shown = np.r_[shown, turn(np.array(p["goal_orientation_wxyz"]), start_q)]
        scaled, self.W = np.array(p["scaled"]), np.array(p["weights"])
        self.scale = np.where(scaled, left, 1.0)
        self.hold = np.where(scaled, 0.0, c["alpha_z"] * c["beta_z"] * (left - shown))
        self.C, self.D = np.array(p["centres"]), np.array(p["widths"])
        self.x, self.tau, self.y, self.q, self.z = 1.0, self.tau0, y, q, velocity * self.tau0
        self.error, self.yr, self.qr, self.vr = np.zeros(6), *self.reference[:2], velocity
        self.level, self.start_force, self.armed = None, force, False
        self.over = self.beyond = self.stalled = self.best = self.done = 0.0
        self.furthest, self.pressed, self.dragged = -np.inf, self.kept(0.0), force
        self.pushed = self.touching() * pushed_at(skill, 0.0)
        self.enter("moving")
        away = np.linalg.norm(y - self.shift - needs["position_m"]) if needs else 0.0
        if needs and (
            away > needs["position_tolerance_m"]
            or (
                needs["orientation_wxyz"]
                and np.linalg.norm(turn(np.array(needs["orientation_wxyz"]), q, True))
                > needs["rotation_tolerance_rad"]
            )
            or any(-force @ np.array(k["direction"]) < k["least_N"] for k in needs["contacts"])
        ):
            self.end("not ready", np.zeros(6))

    def end(self, outcome, velocity):
        skill, ended = self.skill, self.sensed[0]
        if outcome == "contact" and skill["shift_beyond_m"] is not None:
            press = skill["press"] or {
                "direction": skill["travel_direction"],
                "position_m": skill["end_position_m"],
            }
            d = np.array(press["direction"])
            missing = (ended - self.shift - press["position_m"]) @ d
            self.shift = self.shift + d * missing * (abs(missing) > skill["shift_beyond_m"])
        if outcome == "contact" and self.seat:
            self.rotated = times(
                self.sensed[1], np.array(skill["end_orientation_wxyz"]) * [1, -1, -1, -1]
            )
            if self.searched:
                self.shift = ended - skill["press"]["position_m"]
        self.outcomes.append(outcome)
        if outcome not in ("reached", "contact"):
            self.reference, self.pressed = (*self.sensed[:2], np.zeros(6)), []
            self.enter("resting")
        elif len(self.outcomes) == len(self.skills):
            self.pressed = (self.stage == "pressing" and self.pressed) or self.kept(1.0)
            self.enter("resting")
        else:
            self.begin(velocity)

    def follow(self):
        """The reference for the next tick."""
        if self.stage != "moving":
            at = self.press(*self.still)
            seeks = self.seat and self.stage in ("pressing", "searching")
            return self.seek(*at) if seeks else at
        c, h, (at, wxyz, speed, _) = self.skill["primitive"]["constants"], self.h, self.sensed
        self.slow(self.skill["guard"], c)
        for d, _ in self.pressed:
            at = at + (self.y - at) @ d * d
            speed = speed + np.r_[(self.vr[:3] - speed[:3]) @ d * d, 0, 0, 0]
        first = None
        for _ in range(
            parts := max(
                1, int(np.ceil(c["alpha_z"] * h / self.tau / self.e["largest_step"] - 1e-9))
            )
        ):
            acceleration = self.advance(c, h / parts, at, wxyz, speed)
            first = acceleration if first is None else first
        self.vr = self.vr + h * first
        away, far = within(self.yr + h * self.vr[:3] - at, self.e["reach_m"])
        rotation = turn(turned(self.qr, h * self.vr[3:]), wxyz, True)
        rotation, wide = within(rotation, self.e["reach_rad"])
        self.vr = np.where([far] * 3 + [wide] * 3, speed, self.vr)
        self.yr, self.qr = at + away, turned(wxyz, rotation)
        self.done = -np.log(self.x) / (3 * c["alpha_x"])
        self.pressed, span = [], self.skill["demonstrated_s"]
        if span and self.skill["kept"]:
            shown = self.done * self.skill["primitive"]["duration_s"] / (span[1] - span[0])
            share = min(h / self.e["dragged_s"], 1.0)
            self.dragged = self.dragged + share * (self.sensed[3] - self.dragged)
            self.pressed = self.kept(min(shown, 1.0), self.dragged)
            pushed = self.touching() * pushed_at(self.skill, min(shown, 1.0))
            self.pushed = self.pushed + min(h / self.e.get("pushed_s", h), 1.0) * (
                pushed - self.pushed
            )
        at, wxyz, self.velocity = self.press(self.yr, self.qr, self.vr)
        at = at + self.pushed / self.file["gains"]["stiffness_N_m"]
        return self.softly(at, wxyz, self.velocity)

    def softly(self, position, orientation, velocity):
        """A reference so near to the tool that a part of the stiffness is left, and its damping."""
        spread, (at, _, speed, _) = self.skill.get("spread"), self.sensed
        if not spread or "stiffness" not in spread:
            return position, orientation, velocity
        span = self.skill["demonstrated_s"]
        share = min(self.done * self.skill["primitive"]["duration_s"] / (span[1] - span[0]), 1.0)
        parts = spread["stiffness"]
        left = np.interp(share, np.linspace(0, 1, len(parts)), parts)
        firm = [d for d, _ in self.pressed]
        firm += [np.array(self.skill["travel_direction"])] if self.skill["travel_direction"] else []
        across = np.eye(3)
        if firm:
            _, size, spanned = np.linalg.svd(firm)
            across -= (kept := spanned[: len(size)][size > 0.01]).T @ kept
        position = position - (1 - left) * across @ (position - at)
        slower = (1 - np.sqrt(left)) * across @ (velocity - speed)[:3]
        return position, orientation, velocity - np.r_[slower, 0, 0, 0]

    def advance(self, c, h, at, wxyz, speed):
        """One step of the primitive with temporal coupling; the reference acceleration."""
        left = np.r_[self.goal - self.y, turn(self.goal_q, self.q)]
        psi = np.exp(-0.5 * self.D * (self.x - self.C) ** 2)
        force = self.x * (psi @ self.W / (psi.sum() + 1e-10) * self.scale - self.hold)
        away = np.r_[at - self.y, turn(wxyz, self.q, True)]
        rate = c["alpha_e"] * (
            np.r_[1, 1, 1, np.full(3, c["rotation_weight_m"])] * away - self.error
        )
        tau_rate = 2 * c["k_c"] * self.tau * (self.error @ rate)
        tau = self.tau * (1 + c["k_c"] * self.error @ self.error)
        z_rate = (c["alpha_z"] * (c["beta_z"] * left - self.z) + force) / tau
        acceleration = (z_rate - tau_rate / tau * self.z) / tau
        acceleration = acceleration + c["k_v"] * (self.z / tau - speed) - c["k_p"] * away
        self.z, self.x = self.z + h * z_rate, self.x * np.exp(-c["alpha_x"] * h / tau)
        self.y, self.q = self.y + h * self.z[:3] / tau, turned(self.q, h * self.z[3:] / tau)
        self.error = self.error + h * rate
        return acceleration

    def slow(self, guard, c):
        """Time stretched to the speed that is allowed before the contact."""
        if guard:
            ahead = (self.skill["end_position_m"] + self.shift - self.y) @ self.skill[
                "travel_direction"
            ]
            brake = 2 * self.e["brake_m_s2"] * max(ahead - guard["stretch_m"], 0.0)
            allowed = np.sqrt(guard["speed_m_s"] ** 2 + brake)
            tau = self.tau0 * max(1.0, np.linalg.norm(self.z[:3]) / self.tau0 / allowed)
            change = self.z * (1 / tau - 1 / self.tau) / (1 + c["k_c"] * self.error @ self.error)
            self.vr, self.tau = self.vr + change, tau

    def press(self, position, orientation, velocity):
        at = position
        for d, force in self.pressed:
            here = self.sensed[0] @ d + force / self.file["gains"]["stiffness_N_m"]
            at = at + (min(here, position @ d + self.e["followed_beyond_m"]) - at @ d) * d
        return at, orientation, velocity

    def outcome(self, skill):
        """How the skill has ended, if it has."""
        (at, wxyz, _, force), e, end, h = self.sensed, self.e, skill["end_condition"], self.h
        at, arming, travel = at - self.shift, skill["arming"], skill["travel_direction"]
        beyond = (at - skill["end_position_m"]) @ travel if travel else 0.0
        unexpected = np.linalg.norm(force - self.start_force) > skill["force_limit_N"]
        self.beyond = self.beyond + h if unexpected else 0.0
        done = min(self.done, 1.0)
        self.stalled += h
        if beyond >= self.furthest + e["progress_m"] or done >= self.best + e["progress_fraction"]:
            self.stalled, self.best, self.furthest = 0.0, done, max(beyond, self.furthest)
        if end["kind"] == "contact":
            along = force @ np.array(end["direction"])
            if self.level is None:
                self.level = self.start_force @ np.array(end["direction"])
            motion_s = self.done * skill["primitive"]["duration_s"]
            near = beyond >= -arming["within_m"] and motion_s >= arming["after_s"] - 1e-6
            self.armed = self.armed or near
            if not self.armed:
                self.level += min(h / arming["level_s"], 1.0) * (along - self.level)
            self.over = (
                self.over + h if self.armed and along - self.level > end["threshold_N"] else 0.0
            )
            if self.over >= arming["debounce_s"] - 1e-9:
                return "contact"
        if self.beyond >= skill["debounce_s"] - 1e-9:
            return "unexpected contact"
        if beyond > skill["travel_limit_m"]:
            return "too far"
        if end["kind"] == "configuration" and self.done >= 1.0:
            q = np.array(skill["end_orientation_wxyz"])
            near = np.linalg.norm(at - skill["end_position_m"]) <= end["position_tolerance_m"]
            if near and (
                not skill["primitive"]["oriented"]
                or np.linalg.norm(turn(q, wxyz, True)) <= end["rotation_tolerance_rad"]
            ):
                return "reached"
        return "timeout" if self.stalled >= skill["timeout_s"] else ""
