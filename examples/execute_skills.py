"""Execute a skill file (version 2) on any robot, with numpy and json alone: copy and adapt.

plan = Plan("setup1.skills.json", sensed)          sensed = position (3,), orientation w x y z (4,),
while not plan.over:                                        velocity (6,), force on the tool (3,)
    robot.follow(*plan.reference)                  position, orientation, velocity (6,) for 4 ms
    plan.step(sensed)                              plan.outcomes says how each skill ended

Who measures the gripper's opening, in the demonstration's unit, gives it as a fifth value.
"""

import json
from types import SimpleNamespace

import numpy as np

REST, UNTURNED = np.zeros(6), np.array([1.0, 0.0, 0.0, 0.0])


class Named(SimpleNamespace):
    """An object of the file: its values by name, lists as arrays."""

    def __init__(self, values):
        lists = {k: np.array(v) for k, v in values.items() if isinstance(v, list)}
        super().__init__(**{**values, **lists})

    def __getattr__(self, name):
        raise AttributeError(f"the skill file has no '{name}': export it again, with this keyphase")


def times(a, b):
    w, v, x, u = a[0], a[1:], b[0], b[1:]
    return np.array([w * x - v @ u, *(w * u + x * v + np.cross(v, u))])


def gap(to, origin, shortest=True):
    """From one pose (position, orientation) to another: metres and a rotation vector."""
    q = times(to[1], origin[1] * [1, -1, -1, -1])
    q = -q if shortest and q[0] < 0 else q
    sine = np.linalg.norm(q[1:])
    return np.r_[to[0] - origin[0], 2 * np.arctan2(sine, q[0]) / (sine + 1e-300) * q[1:]]


def moved(pose, way):
    """A pose moved by such a gap."""
    half = np.linalg.norm(way[3:]) / 2
    q = times(np.r_[np.cos(half), np.sin(half) / (2 * half + 1e-300) * way[3:]], pose[1])
    return pose[0] + way[:3], q / np.linalg.norm(q)


def alike(q, other):
    """The sign of a quaternion that is nearer to another one."""
    return q if q @ other >= 0 else -q


def beside(v, d):
    return v - v @ d * d


def at_share(rows, share):
    """One of the rows that are spread over a skill, linear in between."""
    place = min(max(share, 0.0), 1.0) * (len(rows) - 1)
    before, after = rows[int(place)], rows[min(int(place) + 1, len(rows) - 1)]
    return before + place % 1 * (after - before)


class Plan:
    def __init__(self, file, sensed):
        with open(file, encoding="utf-8") as text:
            self.file = json.load(text, object_hook=Named)
        if getattr(self.file, "version", None) != 2:
            raise ValueError(f"{file} is no skill file of version 2: export it again")
        self.n, self.h = self.file.execution, self.file.execution.step_s
        self.shift, self.rotated, self.outcomes, self.over = np.zeros(3), UNTURNED, [], False
        self.sense(*sensed)
        self.reference = *self.here, REST
        self.ticks = self.executed()
        next(self.ticks)

    def step(self, sensed):
        """Take in what was sensed at the end of a tick; `reference` is for the next one."""
        self.sense(*sensed)
        if self.s.search:
            self.touch(self.s.press.direction, self.s.search.depth_m)
        if self.s.squaring:
            self.felt = self.felt + self.s.squaring.smoothed * (self.force - self.felt)
        self.over = next(self.ticks, "over") == "over"

    def sense(self, position, orientation, velocity, force, opening=None):
        self.here, self.v = (position, orientation), velocity
        self.force, self.opening = force, opening

    def executed(self):
        """All skills, one after the other; yields once the reference for a tick is there."""
        velocity = REST
        for skill in self.file.skills:
            if skill.connecting:
                self.shift, self.rotated = np.zeros(3), UNTURNED
            outcome, velocity = yield from self.skill(skill, velocity)
            self.outcomes.append(outcome)
            if outcome not in ("reached", "contact"):
                self.reference, self.pressed = (*self.here, REST), []
                break
        yield from self.stay(lambda time: time >= self.n.rest_s)

    def skill(self, s, velocity):
        """Load the contacts it begins in, move, and make the contact it ends in."""
        self.s, self.met, self.sought, self.places = s, False, False, []
        self.fell, self.heavy, self.lost = False, False, 0.0
        self.further = s.guard.further_m if s.guard else 0.0
        self.free = self.felt = self.force
        self.goes_to, self.pressed = s.end_position_m + self.shift, self.kept(0.0)
        if not self.is_loaded():
            most = self.n.pressed_most_s
            yield from self.stay(lambda time: time >= most or self.is_loaded())
            velocity = REST
        if s.precondition and not self.is_ready(s.precondition):
            return "not ready", REST
        outcome = yield from self.moving(s.primitive, velocity)
        velocity, self.pressed = self.velocity, self.kept(1.0, self.force)
        if outcome == "contact" and s.press:
            outcome, velocity = (yield from self.made(s.pressing, s.seeking)), REST
        if outcome == "contact" and s.shift_beyond_m is not None:
            d, places = s.travel_direction, [s.end_position_m, s.met_m]
            d, places = (s.press.direction, [s.press.position_m]) if s.press else (d, places)
            places = [place @ d for place in places if place is not None]
            at = (self.here[0] - self.shift) @ d
            missing = at - np.clip(at, min(places), max(places))
            self.shift = self.shift + d * missing * (abs(missing) > s.shift_beyond_m)
        if outcome == "contact" and s.seeking:
            self.rotated = times(self.here[1], s.end_orientation_wxyz * [1, -1, -1, -1])
            self.shift = self.here[0] - s.press.position_m if self.sought else self.shift
        return outcome, velocity

    def is_loaded(self):
        n, missing = self.n, [(abs(f + self.force @ d), f) for d, f in self.pressed]
        return all(m <= max(n.loaded_within * f, n.loaded_within_N) for m, f in missing)

    def is_ready(self, needs):
        q = self.here[1] if needs.orientation_wxyz is None else needs.orientation_wxyz
        away = gap((needs.position_m + self.shift, q), self.here)
        near = np.linalg.norm(away[:3]) <= needs.position_tolerance_m
        near = near and np.linalg.norm(away[3:]) <= needs.rotation_tolerance_rad
        return near and all(-self.force @ c.direction >= c.least_N for c in needs.contacts)

    # What is pressed

    def kept(self, share, dragged=None):
        """Directions and forces to press with at a share of the demonstrated time."""
        pressed, n = [], self.n
        for kept in self.s.kept:
            near = int(min(max(share, 0.0), 1.0) * (len(kept.force_N) - 1) + 0.5)
            if kept.force_N[near] > 0 and (kept.met or dragged is None or self.touches()):
                d, force = kept.direction[near], at_share(kept.force_N, share)
                if kept.carries and dragged is not None:
                    drags, now = (np.linalg.norm(beside(f, d)) for f in (dragged, self.force))
                    most = (n.gripped_below * self.s.force_limit_N) ** 2 - max(drags, now) ** 2
                    grip = drags / kept.carries, n.gripped_firmer * force, max(most, 0) ** 0.5
                    self.heavy |= now > n.heavy * kept.carries * force
                    force = max(force, min(grip))
                pressed.append((d, force))
        return pressed

    def pushed(self, share):
        rows = [at_share(kept.pushed_N, share) for kept in self.s.kept if kept.pushed_N is not None]
        return np.sum([np.zeros(3), *rows], axis=0) * self.touches()

    def touches(self):
        return np.linalg.norm(self.force) > self.n.touching_N

    def press(self, at):
        wanted = at
        for d, force in self.pressed:
            here = self.here[0] @ d + force / self.file.gains.stiffness_N_m
            wanted = wanted + (min(here, at @ d + self.n.followed_beyond_m) - wanted @ d) * d
        return wanted

    # Where it stands and presses, and a part goes in or is squared

    def stay(self, over, stage=None):
        """Stand where the reference is and press, until it is over, as a stage says."""
        (at, q, _), tick, self.yielded = self.reference, 0, np.zeros(3)
        while tick == 0 or not over(tick * self.h + 1e-9):
            there = self.press(at), q
            self.reference = self.given_way(stage, tick, there) if stage else (*there, REST)
            tick += 1
            yield

    def given_way(self, stage, tick, there):
        """The reference of a stage: moved as the file says, and by what the tool meets."""
        d, now = self.s.press.direction, stage.moves[min(tick, len(stage.moves) - 1)]
        off = gap(there, self.here) + np.r_[now[:3] - self.yielded, 0, 0, 0]
        felt = np.linalg.norm(beside(self.felt - self.free, d))
        left = max(stage.aside_left, min(1.0, stage.yields_N / (felt + 1e-9)))
        lost = (1 - left) * beside(off[:3], d)
        back = stage.returns_1_s * self.h if left == 1 else 0.0
        self.yielded = (1 - back) * self.yielded + stage.stays_aside * lost
        turning = stage.turning_left[int(self.fell or self.sought)]
        at, q = moved(self.here, np.r_[off[:3] - lost, turning * off[3:]])
        return *moved((at, q), np.r_[0, 0, 0, now[3:]]), REST

    def made(self, press, seek):
        """Press a contact that was met; a part is squared on it, or its seat is sought, too."""
        self.met = True
        self.pressed.append((self.s.press.direction, press.force_N))

        def settled(time):
            still = np.linalg.norm(self.v[:3]) < self.n.still_m_s
            return time >= (press.least_s if still else press.most_s)

        yield from self.stay(settled, press)
        presses = 1
        while seek and (not self.is_in() or (self.sinks() and presses < self.n.seat_presses)):
            if self.is_in():
                presses += 1
                yield from self.stay(settled, press)
                continue
            yield from self.stay(lambda t: t > len(seek.moves) * self.h or self.is_in(), seek)
            self.sought = True
            if not self.is_in():
                return "timeout"
            self.reference = *self.here, REST
            yield from self.stay(settled, press)
        if self.s.squaring:
            yield from self.squared(self.s.squaring)
            self.reference = *self.here, REST
            yield from self.stay(settled, press)
        return "contact"

    def squared(self, sq):
        """Follow the strokes that square a part."""
        places, q = self.strokes(sq, self.here[0]), self.reference[1]
        now = next(places)
        for then in places:
            self.reference, now = (now, q, np.r_[(then - now) / self.h, 0, 0, 0]), then
            yield
        self.reference = now, q, REST
        yield

    def strokes(self, sq, at):
        """Where the tool is to be: lifted, at rest, moved along two axes, and put down."""
        lift, aside = -sq.lift_m * sq.normal, self.goes_to - at
        lifting = round(sq.lift_s / self.h)
        eased = (1 - np.cos(np.pi * np.arange(lifting) / lifting)) / 2
        yield from (at + share * lift for share in eased)
        at, self.free, still = at + lift, np.zeros(3), round(sq.still_s / self.h)
        for _ in range(still):
            yield at
            self.free = self.free + self.force / still
        for way, count in zip((np.cross(sq.normal, sq.along), sq.along), sq.strokes, strict=True):
            ends, sides, side = [0.0], [], None
            for n in range(count - 1):
                reach = sq.reach_m * (-1) ** n
                goal = ends[-1] + 2 * reach if n else aside @ way + reach
                lasts = sq.flush_s if n >= count - 1 - sq.flushing else sq.felt_s
                end, side = yield from self.stroke(sq, at, way, ends[-1], goal, lasts)
                ends.append(end)
                sides += [] if side is None else [(self.here[0] - at) @ way]
            back = aside @ way
            if side is not None and len(sides) >= sq.sides:
                back = sides[-1] + (sides[-2] - side) / 2
            end, _ = yield from self.stroke(sq, at, way, ends[-1], back, np.inf)
            at = at + end * way
        yield from (at - share * lift for share in eased)

    def stroke(self, sq, at, way, place, goal, lasts):
        """One stroke; returns where it ended, and where it met a side that it felt for so long."""
        sign, time, resisted, met = 1 if goal > place else -1, 0.0, 0.0, place
        while sign * (goal - place) > 0:
            time += self.h
            place += sign * sq.speed_m_s * self.h * min(1, time / sq.ramp_s)
            yield at + place * way
            resists = sign * (self.free - self.felt) @ way
            resisted = resisted + self.h if resists > sq.felt_N else 0.0
            if not resisted:
                met = (self.here[0] - at) @ way
            if abs(resists) <= sq.felt_N:
                self.free = self.free + sq.forgets * (self.force - self.free)
            if time > sq.ramp_s and (resists > sq.press_N or resisted >= lasts - 1e-9):
                return place, met
        return place, None

    def touch(self, d, depth):
        """Where the tool first touched what it is to go into, and whether it fell into it."""
        self.felt = self.felt + self.n.touch_smoothed * (self.force - self.felt)
        self.lost = self.lost + self.h if (self.free - self.felt) @ d < self.n.touch_N else 0.0
        forgotten = self.lost > self.n.bounce_s + 1e-9 and not self.met
        if self.lost and (forgotten or not self.places):
            self.places, self.fell = [], False
            return
        self.places.append(self.here[0] @ d)
        recent = self.places[-max(1, round(self.n.seat_fall_s / self.h)) :]
        self.fell |= self.places[-1] - min(recent) >= self.n.seat_fall * depth

    def sinks(self):
        now, last = self.places[-1:], len(self.places)
        ago = ((self.places[-min(round(t / self.h), last)], m) for t, m in self.n.seat_sinking)
        return any(now[0] - place >= m for place, m in ago)

    def is_in(self):
        least = self.s.search.depth_m * (self.n.seat_fell if self.fell else self.n.seat_crept)
        return bool(self.places) and self.places[-1] - min(self.places) >= least

    # How it moves: a dynamical movement primitive with temporal coupling

    def moving(self, p, velocity):
        """Until the skill is over; returns how it ended."""
        c, start = p.constants, alike(self.here[1], p.start_orientation_wxyz)
        goal = alike(times(self.rotated, p.goal_orientation_wxyz), p.goal_orientation_wxyz)
        self.goal = p.goal_position_m + self.shift, goal if p.oriented else start
        self.y, self.x, self.error = (self.here[0], start), 1.0, REST
        shown = p.goal_position_m, p.goal_orientation_wxyz
        shown = gap(shown, (p.start_position_m, p.start_orientation_wxyz), False)
        left = gap(self.goal, self.y, False)
        self.scale = np.where(p.scaled, left, 1.0)
        self.hold = np.where(p.scaled, 0.0, c.alpha_z * c.beta_z * (left - shown))
        self.tau, self.z, self.vr = p.duration_s / 3, velocity * p.duration_s / 3, velocity
        self.yr, self.dragged, self.pushes = self.reference[:2], self.force, self.pushed(0.0)
        self.pressed = self.kept(0.0, self.force)
        self.first_force, self.level, self.armed, self.furthest = self.force, None, False, -np.inf
        self.risen = self.beyond = self.stalled = self.best = self.done = 0.0
        self.begun_at, self.stands, outcome = None, -self.h, ""
        while not outcome:
            self.reference = self.follow()
            yield
            outcome = self.outcome(self.s.end_condition)
        return outcome

    def follow(self):
        """The reference for the next tick."""
        s, h, n, at, v, c = self.s, self.h, self.n, self.here[0], self.v, self.s.primitive.constants
        self.slow(s.guard)
        for d, _ in self.pressed:
            at = at + (self.y[0] - at) @ d * d
            v = v + np.r_[(self.vr[:3] - v[:3]) @ d * d, 0, 0, 0]
        here = at, self.here[1]
        parts = max(1, int(np.ceil(c.alpha_z * h / self.tau / n.largest_step - 1e-9)))
        accelerations = [self.advance(c, h / parts, here, v) for _ in range(parts)]
        self.vr = self.vr + h * np.mean(accelerations, axis=0)
        away = gap(moved(self.yr, h * self.vr), here)
        far = np.linalg.norm(away[:3]) / n.reach_m, np.linalg.norm(away[3:]) / n.reach_rad
        far = np.maximum(np.repeat(far, 3), 1.0)
        self.vr, self.yr = np.where(far > 1, v, self.vr), moved(here, away / far)
        self.done, self.pressed, self.velocity = -np.log(self.x) / (3 * c.alpha_x), [], self.vr
        if s.demonstrated_s is None:
            return *self.yr, self.vr
        share = min(self.done * s.primitive.duration_s / np.ptp(s.demonstrated_s), 1.0)
        self.dragged = self.dragged + min(h / n.dragged_s, 1) * (self.force - self.dragged)
        self.pressed = self.kept(share, self.dragged)
        self.pushes = self.pushes + min(h / n.pushed_s, 1) * (self.pushed(share) - self.pushes)
        at = self.press(self.yr[0]) + self.pushes / self.file.gains.stiffness_N_m
        return self.softly(at, self.yr[1], self.vr, share)

    def slow(self, guard):
        """Stretch time to the speed that is allowed before a contact, and with what is heavy."""
        allowed = self.n.heavy_m_s if self.heavy else np.inf
        if guard:
            ahead = (self.goes_to - self.y[0]) @ self.s.travel_direction - guard.stretch_m
            near = np.sqrt(guard.speed_m_s**2 + 2 * self.n.brake_m_s2 * max(ahead, 0.0))
            allowed = min(allowed, near)
        tau = max(self.s.primitive.duration_s / 3, np.linalg.norm(self.z[:3]) / allowed)
        if guard and self.done >= 1:
            step = min(guard.speed_m_s * self.h, self.further)
            self.goal = self.goal[0] + step * self.s.travel_direction, self.goal[1]
            self.further -= step
        slower = 1 + self.s.primitive.constants.k_c * self.error @ self.error
        self.vr, self.tau = self.vr + self.z * (1 / tau - 1 / self.tau) / slower, tau

    def advance(self, c, h, here, v):
        """One step of the primitive; the reference acceleration."""
        p, left, away = self.s.primitive, gap(self.goal, self.y, False), gap(here, self.y)
        psi = np.exp(-0.5 * p.widths * (self.x - p.centres) ** 2)
        force = self.x * (psi @ p.weights / (psi.sum() + 1e-10) * self.scale - self.hold)
        rate = c.alpha_e * (np.repeat([1.0, c.rotation_weight_m], 3) * away - self.error)
        tau = self.tau * (1 + c.k_c * self.error @ self.error)
        tau_rate = 2 * c.k_c * self.tau * (self.error @ rate)
        z_rate = (c.alpha_z * (c.beta_z * left - self.z) + force) / tau
        acceleration = (z_rate - tau_rate / tau * self.z) / tau
        acceleration = acceleration + c.k_v * (self.z / tau - v) - c.k_p * away
        self.z, self.x = self.z + h * z_rate, self.x * np.exp(-c.alpha_x * h / tau)
        self.y, self.error = moved(self.y, h * self.z / tau), self.error + h * rate
        return acceleration

    def softly(self, at, q, v, share):
        """Nearer to the tool, where demonstrations lay apart: less stiff, as well damped."""
        if not hasattr(self.s, "spread"):
            return at, q, v
        left, travel = at_share(self.s.spread.stiffness, share), self.s.travel_direction
        firm = [d for d, _ in self.pressed] + ([] if travel is None else [travel])
        firm = np.reshape(firm, (-1, 3))
        across = np.eye(3) - np.linalg.pinv(firm, 0.01) @ firm
        slower = (1 - np.sqrt(left)) * across @ (v - self.v)[:3]
        return at - (1 - left) * across @ (at - self.here[0]), q, v - np.r_[slower, 0, 0, 0]

    # When it is over

    def outcome(self, end):
        """How the skill has ended, if it has."""
        s, n, done, travel = self.s, self.n, min(self.done, 1.0), self.s.travel_direction
        off = gap((self.goes_to, s.end_orientation_wxyz), self.here)
        ahead = 0.0 if travel is None else -off[:3] @ travel
        change, felt = (np.linalg.norm(f) for f in (self.force - self.first_force, self.force))
        unexpected = change > s.force_limit_N and felt > n.fell_away * change
        self.beyond = self.beyond + self.h if unexpected else 0.0
        gripped = not hasattr(end, "gripper") or self.has_gripped(end.gripper)
        self.stalled += self.h
        if ahead >= self.furthest + n.progress_m or done >= self.best + n.progress_fraction:
            self.stalled, self.best, self.furthest = 0.0, done, max(ahead, self.furthest)
        if end.kind == "contact" and self.is_met(end, ahead, s.arming):
            return "contact"
        if self.beyond >= s.debounce_s - 1e-9:
            return "unexpected contact"
        if ahead > s.travel_limit_m:
            return "too far"
        if end.kind == "configuration" and self.done >= 1.0 and gripped:
            near = np.linalg.norm(off[:3]) <= end.position_tolerance_m
            turns = np.linalg.norm(off[3:]) if s.primitive.oriented else 0.0
            if near and turns <= end.rotation_tolerance_rad:
                return "reached"
        return "timeout" if self.stalled >= s.timeout_s else ""

    def is_met(self, end, ahead, arming):
        """Whether the force has risen by the threshold for long enough, near the contact."""
        along = self.force @ end.direction
        self.level = self.first_force @ end.direction if self.level is None else self.level
        late = self.done * self.s.primitive.duration_s >= arming.after_s - 1e-6
        self.armed = self.armed or (late and ahead >= -arming.within_m)
        if not self.armed:
            self.level += min(self.h / arming.level_s, 1.0) * (along - self.level)
        gone = end.release and self.done >= 1.0 and not self.touches()
        rises = self.armed and (gone or along - self.level > end.threshold_N)
        self.risen = self.risen + self.h if rises else 0.0
        return self.risen >= arming.debounce_s - 1e-9

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
