"""Execute a skill file (version 2) on any robot, with numpy and json alone: copy and adapt.

plan = Plan("setup1.skills.json", sensed)          sensed = position (3,), orientation w x y z (4,),
while plan.stage != "over":                                 velocity (6,), force on the tool (3,)
    robot.follow(*plan.reference)                  position, orientation, velocity (6,) for 4 ms
    plan.step(sensed)                              plan.outcomes says how each skill ended

Who measures the gripper's opening, in the demonstration's unit, gives it as a fifth value.
"""

import json

import numpy as np

REST = np.zeros(6)


class Values(dict):
    """An object of the file: its values by name, lists of numbers as arrays."""

    __getattr__ = dict.__getitem__


def values(pairs):
    def is_numbers(v):
        return isinstance(v, list) and not any(isinstance(each, dict) for each in v)

    return Values((k, np.array(v) if is_numbers(v) else v) for k, v in pairs)


def times(a, b):
    w, v, x, u = a[0], a[1:], b[0], b[1:]
    return np.array([w * x - v @ u, *(w * u + x * v + np.cross(v, u))])


def turn(to, origin, shortest=True):
    """Rotation vector from one orientation to another."""
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


def at_share(rows, share):
    """One of the rows that are spread over a skill, linear in between."""
    place = min(max(share, 0.0), 1.0) * (len(rows) - 1)
    before, after = rows[int(place)], rows[min(int(place) + 1, len(rows) - 1)]
    return before + place % 1 * (after - before)


class Plan:
    def __init__(self, file, sensed):
        with open(file, encoding="utf-8") as text:
            self.file = json.load(text, object_pairs_hook=values)
        self.n, self.h, self.k = self.file.execution, self.file.execution.step_s, self.file.gains
        self.sense(*sensed)
        self.shift, self.outcomes, self.rotated = np.zeros(3), [], np.array([1.0, 0, 0, 0])
        self.reference = self.at, self.q, REST
        self.begin(REST)
        self.reference = self.follow()

    def sense(self, position, orientation, velocity, force, opening=None):
        self.at, self.q, self.v = position, orientation, velocity
        self.force, self.opening = force, opening

    def step(self, sensed):
        """Take in what was sensed at the end of a tick: the next stage, where this one is over."""
        self.sense(*sensed)
        self.time += self.h
        time, n, s = self.time + 1e-9, self.n, self.s
        self.touch()
        if self.stage == "moving":
            outcome = self.outcome()
            if outcome == "contact" and s.press:
                firmly = max(s.press.force_N, self.seat.press_N if self.seat else 0.0)
                self.pressed = [*self.kept(1.0, self.force), (s.press.direction, firmly)]
                self.enter("pressing")
            elif outcome:
                self.end(outcome, self.velocity)
        elif self.stage == "pressing":
            still = np.linalg.norm(self.v[:3]) < n.still_m_s
            pressed = time >= n.pressed_most_s or (time >= n.pressed_least_s and still)
            if (time >= n.seating_s if self.seat else pressed) and self.is_in():
                self.end("contact")
            elif self.seat and time >= n.seating_s:
                off, self.yielded, self.moves_from = self.goes_to - self.at, np.zeros(3), self.at
                self.aside = off - off @ self.seat.normal * self.seat.normal if s.squaring else 0
                self.enter("searching")
        elif self.stage == "searching":
            if self.is_in():
                self.reference, self.searched = (self.at, self.q, REST), True
                self.enter("pressing")
            elif s.search and time >= s.search.duration_s:
                self.end("timeout")
        elif self.stage == "loading" and (time >= n.pressed_most_s or self.is_loaded()):
            self.move(REST)
        elif self.stage == "resting" and time >= n.rest_s:
            self.stage = "over"
        self.reference = self.follow()

    def enter(self, stage):
        self.stage, self.time, self.still = stage, 0.0, (*self.reference[:2], REST)

    def begin(self, velocity):
        self.s = s = self.file.skills[len(self.outcomes)]
        if s.connecting:
            self.shift, self.rotated = np.zeros(3), np.array([1.0, 0, 0, 0])
        self.goes_to, self.seat = s.end_position_m + self.shift, s.search or s.squaring
        self.searched, self.squared, self.places, self.fell = False, 0.0, [], False
        self.felt = self.free = -self.force @ s.press.direction if s.search else 0.0
        self.pressed = self.kept(0.0)
        self.move(velocity) if self.is_loaded() else self.enter("loading")

    def is_loaded(self):
        n = self.n
        least = [max(n.loaded_within * f, n.loaded_within_N) for _, f in self.pressed]
        missing = [abs(f + self.force @ d) for d, f in self.pressed]
        return all(m <= most for m, most in zip(missing, least, strict=True))

    def end(self, outcome, velocity=REST):
        s = self.s
        if outcome == "contact" and s.shift_beyond_m is not None:
            d, there = s.travel_direction, s.end_position_m
            d, there = (s.press.direction, s.press.position_m) if s.press else (d, there)
            missing = (self.at - self.shift - there) @ d
            self.shift = self.shift + d * missing * (abs(missing) > s.shift_beyond_m)
        if outcome == "contact" and self.seat:
            self.rotated = times(self.q, s.end_orientation_wxyz * [1, -1, -1, -1])
            self.shift = self.at - s.press.position_m if self.searched else self.shift
        self.outcomes.append(outcome)
        if outcome not in ("reached", "contact"):
            self.reference, self.pressed = (self.at, self.q, REST), []
            self.enter("resting")
        elif len(self.outcomes) == len(self.file.skills):
            here = self.pressed if self.stage == "pressing" else []
            self.pressed = here or self.kept(1.0, self.force)
            self.enter("resting")
        else:
            self.begin(velocity)

    # What is pressed

    def kept(self, share, dragged=None):
        """Directions and forces to press with at a share of the demonstrated time."""
        pressed, n = [], self.n
        for kept in self.s.kept:
            near = int(min(max(share, 0.0), 1.0) * (len(kept.force_N) - 1) + 0.5)
            if kept.force_N[near] > 0 and (kept.met or dragged is None or self.touches()):
                d, force = kept.direction[near], at_share(kept.force_N, share)
                if kept.carries and dragged is not None:
                    drags = np.linalg.norm(dragged - dragged @ d * d)
                    most = (n.gripped_below * self.s.force_limit_N) ** 2 - drags**2
                    grip = drags / kept.carries, n.gripped_firmer * force, max(most, 0) ** 0.5
                    force = max(force, min(grip))
                pressed.append((d, force))
        return pressed

    def pushed_at(self, share):
        rows = [at_share(kept.pushed_N, share) for kept in self.s.kept if kept.pushed_N is not None]
        return np.sum([np.zeros(3), *rows], axis=0) * self.touches()

    def touches(self):
        return np.linalg.norm(self.force) > self.n.touching_N

    def press(self, at, q, v):
        wanted = at
        for d, force in self.pressed:
            here = self.at @ d + force / self.k.stiffness_N_m
            wanted = wanted + (min(here, at @ d + self.n.followed_beyond_m) - wanted @ d) * d
        return wanted, q, v

    # Where a part goes in

    def touch(self):
        """Where the tool first touched what it is to go into, and whether it fell into it."""
        if not self.s.search:
            return
        d, n = self.s.press.direction, self.n
        self.felt += n.touch_smoothed * (-self.force @ d - self.felt)
        if self.felt - self.free < n.touch_N and not (self.stage != "moving" and self.places):
            self.places, self.fell = [], False
            return
        self.places.append(self.at @ d)
        recent = self.places[-max(1, round(n.seat_fall_s / self.h)) :]
        self.fell |= self.at @ d - min(recent) >= n.seat_fall * self.s.search.depth_m

    def is_in(self):
        if self.s.search:
            place = self.at @ self.s.press.direction
            least = self.s.search.depth_m * (1.0 if self.fell else self.n.seat_crept)
            return place - min(self.places, default=place) >= least
        return not self.seat or self.squared >= 10 * self.seat.stroke_s

    def seek(self, at, q, v):
        """A reference that the seat can move and turn; a search goes along the file's moves."""
        moves, tick, d, n = self.s.moves, round(self.time / self.h), self.s.press.direction, self.n
        if self.stage == "searching" and self.s.squaring:
            self.squared = self.time
            now, then = (moves.aside_m[min(tick + i, len(moves.aside_m) - 1)] for i in (0, 1))
            now, then = (row[:3] + row[3] * self.aside for row in (now, then))
            return self.moves_from + now, q, np.r_[(then - now) / self.h, 0, 0, 0]
        tips = self.s.search and not (self.stage == "pressing" and self.fell)
        left = n.seat_turning if tips else n.squared_turning
        q = turned(self.q, left * turn(q, self.q))
        if self.stage == "pressing":
            off = at - self.at
            at = at - (1 - n.seat_giving) * (off - off @ d * d)
            return at, turned(q, moves.rocked_rad[min(tick, len(moves.rocked_rad) - 1)]), v
        at = at + moves.aside_m[min(tick, len(moves.aside_m) - 1)][:3] - self.yielded
        off, felt = (u - u @ d * d for u in (at - self.at, self.force))
        size, most = np.linalg.norm(felt), n.seat_yields * self.seat.press_N
        beyond = (1 - most / size) * off if size > most else 0 * off
        self.yielded = self.yielded + beyond
        return at - beyond, q, v

    # How it moves: a dynamical movement primitive with temporal coupling

    def move(self, velocity):
        s, p, c, (y, q) = self.s, self.s.primitive, self.s.primitive.constants, (self.at, self.q)
        q = q if q @ p.start_orientation_wxyz >= 0 else -q
        self.goal, self.goal_q = p.goal_position_m + self.shift, q
        if p.oriented:
            self.goal_q = times(self.rotated, p.goal_orientation_wxyz)
            self.goal_q = self.goal_q * (1 if self.goal_q @ p.goal_orientation_wxyz >= 0 else -1)
        left = np.r_[self.goal - y, turn(self.goal_q, q, False)]
        shown = turn(p.goal_orientation_wxyz, p.start_orientation_wxyz, False)
        shown = np.r_[p.goal_position_m - p.start_position_m, shown]
        self.scale = np.where(p.scaled, left, 1.0)
        self.hold = np.where(p.scaled, 0.0, c.alpha_z * c.beta_z * (left - shown))
        self.tau0 = self.tau = p.duration_s / 3
        self.x, self.y, self.yq, self.z, self.error = 1.0, y, q, velocity * self.tau, REST
        (self.yr, self.qr, _), self.vr = self.reference, velocity
        self.level, self.first_force, self.armed, self.furthest = None, self.force, False, -np.inf
        self.over = self.beyond = self.stalled = self.best = self.done = 0.0
        self.begun_at, self.stands = None, -self.h
        self.pressed, self.dragged = self.kept(0.0, self.force), self.force
        self.pushed = self.pushed_at(0.0)
        self.enter("moving")
        if not self.is_ready(s.precondition):
            self.end("not ready")

    def is_ready(self, needs):
        if not needs:
            return True
        away, q = self.at - self.shift - needs.position_m, needs.orientation_wxyz
        turns = 0.0 if q is None else np.linalg.norm(turn(q, self.q))
        return (
            np.linalg.norm(away) <= needs.position_tolerance_m
            and turns <= needs.rotation_tolerance_rad
            and all(-self.force @ held.direction >= held.least_N for held in needs.contacts)
        )

    def follow(self):
        """The reference for the next tick."""
        s, h, n, at, v = self.s, self.h, self.n, self.at, self.v
        if self.stage != "moving":
            seeks = self.seat and self.stage in ("pressing", "searching")
            return self.seek(*self.press(*self.still)) if seeks else self.press(*self.still)
        c, self.tau = s.primitive.constants, self.slowed(s.guard, s.primitive.constants)
        for d, _ in self.pressed:
            at = at + (self.y - at) @ d * d
            v = v + np.r_[(self.vr[:3] - v[:3]) @ d * d, 0, 0, 0]
        parts = max(1, int(np.ceil(c.alpha_z * h / self.tau / n.largest_step - 1e-9)))
        accelerations = [self.advance(c, h / parts, at, v) for _ in range(parts)]
        self.vr = self.vr + h * accelerations[0]
        away, far = within(self.yr + h * self.vr[:3] - at, n.reach_m)
        rotation, wide = within(turn(turned(self.qr, h * self.vr[3:]), self.q), n.reach_rad)
        self.vr = np.where([far] * 3 + [wide] * 3, v, self.vr)
        self.yr, self.qr = at + away, turned(self.q, rotation)
        self.done, self.pressed = -np.log(self.x) / (3 * c.alpha_x), []
        span = s.demonstrated_s
        share = span is not None and min(self.done * s.primitive.duration_s / np.ptp(span), 1.0)
        if len(s.kept) and span is not None:
            self.dragged = self.dragged + min(h / n.dragged_s, 1) * (self.force - self.dragged)
            self.pressed = self.kept(share, self.dragged)
            pushed = self.pushed_at(share) - self.pushed
            self.pushed = self.pushed + min(h / n.pushed_s, 1) * pushed
        at, q, self.velocity = self.press(self.yr, self.qr, self.vr)
        return self.softly(at + self.pushed / self.k.stiffness_N_m, q, self.velocity, share)

    def slowed(self, guard, c):
        """The time constant, stretched to the speed that is allowed before the contact."""
        if not guard:
            return self.tau
        ahead = (self.goes_to - self.y) @ self.s.travel_direction - guard.stretch_m
        allowed = np.sqrt(guard.speed_m_s**2 + 2 * self.n.brake_m_s2 * max(ahead, 0.0))
        tau = self.tau0 * max(1.0, np.linalg.norm(self.z[:3]) / self.tau0 / allowed)
        change = self.z * (1 / tau - 1 / self.tau) / (1 + c.k_c * self.error @ self.error)
        self.vr = self.vr + change
        return tau

    def advance(self, c, h, at, v):
        """One step of the primitive; the reference acceleration."""
        p, left = self.s.primitive, np.r_[self.goal - self.y, turn(self.goal_q, self.yq, False)]
        psi = np.exp(-0.5 * p.widths * (self.x - p.centres) ** 2)
        force = self.x * (psi @ p.weights / (psi.sum() + 1e-10) * self.scale - self.hold)
        away = np.r_[at - self.y, turn(self.q, self.yq)]
        rate = c.alpha_e * (np.r_[np.ones(3), np.full(3, c.rotation_weight_m)] * away - self.error)
        tau = self.tau * (1 + c.k_c * self.error @ self.error)
        tau_rate = 2 * c.k_c * self.tau * (self.error @ rate)
        z_rate = (c.alpha_z * (c.beta_z * left - self.z) + force) / tau
        acceleration = (z_rate - tau_rate / tau * self.z) / tau
        acceleration = acceleration + c.k_v * (self.z / tau - v) - c.k_p * away
        self.z, self.x = self.z + h * z_rate, self.x * np.exp(-c.alpha_x * h / tau)
        self.y, self.yq = self.y + h * self.z[:3] / tau, turned(self.yq, h * self.z[3:] / tau)
        self.error = self.error + h * rate
        return acceleration

    def softly(self, at, q, v, share):
        """Nearer to the tool, where demonstrations lay apart: less stiff, as well damped."""
        spread, s = self.s.get("spread"), self.s
        if not spread:
            return at, q, v
        left, across = at_share(spread.stiffness, share), np.eye(3)
        firm = [d for d, _ in self.pressed]
        firm += [] if s.travel_direction is None else [s.travel_direction]
        if firm:
            _, size, spanned = np.linalg.svd(firm)
            across -= (kept := spanned[: len(size)][size > 0.01]).T @ kept
        slower = (1 - np.sqrt(left)) * across @ (v - self.v)[:3]
        return at - (1 - left) * across @ (at - self.at), q, v - np.r_[slower, 0, 0, 0]

    # When it is over

    def outcome(self):
        """How the skill has ended, if it has."""
        s, n, end, h, travel = self.s, self.n, self.s.end_condition, self.h, self.s.travel_direction
        off = self.at - self.goes_to
        beyond, done = (0.0 if travel is None else off @ travel), min(self.done, 1.0)
        change, felt = (np.linalg.norm(f) for f in (self.force - self.first_force, self.force))
        unexpected = change > s.force_limit_N and felt > n.fell_away * change
        self.beyond = self.beyond + h if unexpected else 0.0
        gripped = not end.get("gripper") or self.has_gripped(end.gripper)
        self.stalled += h
        if beyond >= self.furthest + n.progress_m or done >= self.best + n.progress_fraction:
            self.stalled, self.best, self.furthest = 0.0, done, max(beyond, self.furthest)
        if end.kind == "contact" and self.is_met(end, beyond):
            return "contact"
        if self.beyond >= s.debounce_s - 1e-9:
            return "unexpected contact"
        if beyond > s.travel_limit_m:
            return "too far"
        if end.kind == "configuration" and self.done >= 1.0:
            wide = np.linalg.norm(turn(s.end_orientation_wxyz, self.q)) * s.primitive.oriented
            near = np.linalg.norm(off) <= end.position_tolerance_m
            if gripped and near and wide <= end.rotation_tolerance_rad:
                return "reached"
        return "timeout" if self.stalled >= s.timeout_s else ""

    def has_gripped(self, grip):
        """Whether the gripper has done its part; of whom nobody measures it, it is not asked."""
        opening = self.opening
        if opening is None:
            return True
        if self.begun_at is None:
            self.begun_at = self.stood_at = opening
        self.stands += self.h
        if abs(opening - self.stood_at) > self.n.gripper_still * abs(opening - self.begun_at):
            self.stands, self.stood_at = 0.0, opening
        if grip.change == "release":
            return opening > grip.opening + grip.tolerance
        stalled = self.stands >= grip.stalled_s and self.begun_at - opening >= grip.tolerance
        return opening <= grip.opening + grip.tolerance or stalled

    def is_met(self, end, beyond):
        """Whether the force has risen by the threshold for long enough, near the contact."""
        arming, along = self.s.arming, self.force @ end.direction
        self.level = self.first_force @ end.direction if self.level is None else self.level
        late = self.done * self.s.primitive.duration_s >= arming.after_s - 1e-6
        self.armed = self.armed or (late and beyond >= -arming.within_m)
        if not self.armed:
            self.level += min(self.h / arming.level_s, 1.0) * (along - self.level)
        rises = self.armed and along - self.level > end.threshold_N
        self.over = self.over + self.h if rises else 0.0
        return self.over >= arming.debounce_s - 1e-9
