"""Diagnosis of gap datasets with numpy and scipy, one thread: `gap_scipy.py DATASET...`

A plain implementation of the task of `calib gap diagnose` on points, with formulas of its
own, as a measure of speed: the same 42 candidates and their pairs, each refined by
`scipy.optimize.least_squares` together with all nuisances; a nonlinear exciter by harmonic
balance over all rows at once. It leaves out what does not weigh on time: held-out
rows, tests of what is left, probabilities, leakage of unlocked tones into components,
harmonics through the channels' own responses.

Prints a line of JSON for each dataset: {"seconds": processor time, "first": names}.
"""

import csv
import json
import os
import sys
import time
import tomllib

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np  # noqa: E402
from scipy.optimize import least_squares  # noqa: E402

POINTS = 64  # of a period in the balance
ORDERS = 9  # solved for
COSINE = np.cos(2 * np.pi * np.arange(POINTS) / POINTS)
SIDE = 14  # refined singles
BASES = 5  # singles from which pairs grow
GROWN = 3  # pairs from each


class Dataset:
    """Whitened data and conditions, by row."""

    def __init__(self, folder):
        with open(os.path.join(folder, "rig.toml"), "rb") as file:
            self.rig = tomllib.load(file)
        with open(os.path.join(folder, "points.csv"), newline="") as file:
            rows = list(csv.DictReader(file))

        def column(name, default=0.0):
            return np.array([float(r.get(name) or default) for r in rows])

        rad = np.pi / 180
        self.f = column("frequency_hz")
        self.w = 2 * np.pi * self.f
        self.time = column("time_s")
        self.warm = column("temperature_c", 23.0) - self.rig["environment"]["reference_temperature_c"]
        self.turn = column("rotation_deg") * rad
        self.up = np.cos(column("tilt_deg") * rad)
        self.payload = column("payload_kg")
        self.level = column("acceleration_ms2")
        labels = [r.get("run", "") for r in rows]
        self.run = np.array([sorted(set(labels)).index(x) for x in labels])
        coil, ref, dut = column("coil_v"), column("ref_v"), column("dut_v")
        data = [np.log(dut / ref), column("dut_deg") * rad, np.log(ref / coil), column("ref_deg") * rad]
        data += [np.log(column("coil_a") / coil), column("coil_a_deg") * rad]
        u = [column("u_ratio"), column("u_phase_deg") * rad] + [column("u_drive")] * 2
        u += [column("u_current")] * 2
        for channel in ("ref", "dut"):
            for n in range(2, 6):
                angle = column(f"{channel}_h{n}_deg") * rad
                value = column(f"{channel}_h{n}") * np.exp(1j * angle)
                data += [value.real, value.imag]
        u += [column("u_harmonic")] * 16
        data += [column("ref_dc_v"), column("dut_dc_v")]
        u += [column("u_dc_v")] * 2
        data += [np.log(column("ref_noise_v")), np.log(column("dut_noise_v"))]
        u += [np.full(len(rows), 0.01)] * 2
        self.data, self.u = np.array(data), np.array(u)

        def entry(table, name):
            q = self.rig[table][name]
            return q["value"], q["u"]

        names = "moving_mass_kg stiffness_n_per_m damping_ns_per_m force_factor_n_per_a"
        names += " coil_resistance_ohm coil_inductance_h"
        exciter = [entry("exciter", n) for n in names.split()]
        self.exciter = np.array([e[0] for e in exciter])
        self.exciter_u = np.array([e[1] / e[0] for e in exciter])
        self.s1, s1_u = entry("reference", "sensitivity_v_per_ms2")
        self.s2, _ = entry("dut", "sensitivity_v_per_ms2")
        self.noise = self.rig["digitiser"]["noise_v"]["value"]
        runs = self.run.max() + 1
        repeat = self.rig["repeatability"]
        # Ratio gain (free), drive gain, exciter, gains of each run, healthy noise of each channel.
        self.units = np.concatenate([
            [0.01, s1_u / self.s1], self.exciter_u,
            np.full(runs, repeat["reference_gain"]), np.full(runs, repeat["dut_gain"]),
            np.full(2, np.sqrt(2) * 0.01),
        ])
        self.prior = np.ones(len(self.units))
        self.prior[0] = 0.0


class State:
    """A row of responses, on which effects act."""

    def __init__(self, d, theta):
        m, k, c, bl, r, l = d.exciter * (1 + d.exciter_u * theta[2:8])
        one = np.ones(len(d.f))
        self.m, self.k, self.c, self.bl = m + d.payload, k * one, c * one, bl * one
        self.r, self.l, self.exponent, self.emf = r * one, l, 1.0, one
        self.k2 = self.k3 = self.droop = self.friction = self.even = 0.0
        self.limit = np.inf
        self.bent = False
        self.motion = one.astype(complex)  # table travel over the rigid one
        self.gain = [one.astype(complex), one.astype(complex)]  # reference, device
        self.amplifier = one.copy()
        self.curves = []  # (channel, function of volts)
        self.added = [0.0, 0.0]  # noise power
        self.h2 = 0.0

    def impedance(self, w):
        w0 = 2000 * np.pi
        lossy = (1j ** self.exponent) * w0 * self.l * (w / w0) ** self.exponent
        return self.r[..., None] + lossy if w.ndim > 1 else self.r + lossy


def resonance(f, fr, q):
    return 1 / (1 - (f / fr) ** 2 + 1j * f / (q * fr))


def highpass(f, fc):
    return 1j * f / fc / (1 + 1j * f / fc)


# Each effect: function(state, dataset, parameters), starts, lower and upper bounds.
EFFECTS = {}


def effect(starts, lower, upper):
    def register(function):
        EFFECTS[function.__name__] = (function, np.atleast_2d(starts), np.atleast_1d(lower), np.atleast_1d(upper))
        return function
    return register


def acts(name, channel, formula, starts, lower, upper):
    """An effect that is a complex factor on one channel."""
    def function(s, d, p):
        s.gain[channel] = s.gain[channel] * formula(d, p)
    function.__name__ = name
    effect(starts, lower, upper)(function)


def grid(values, *others):
    return [[v, *others] for v in values]


REF, DUT = 0, 1
HZ = [7e3, 12e3, 20e3, 40e3]
acts("dut_resonance", DUT, lambda d, p: resonance(d.f, *p), grid(HZ, 10), [2e3, 1.5], [1.2e5, 1e3])
acts("reference_resonance", REF, lambda d, p: resonance(d.f, *p), grid(HZ, 10), [2e3, 1.5], [1.2e5, 1e3])
acts("mount_compliance", DUT, lambda d, p: resonance(d.f, np.sqrt(np.exp(p[0]) / np.maximum(d.payload, 1e-6)) / 2 / np.pi, p[1]),
     grid(np.log([1e8, 1e9]), 10), [11.5, 1.5], [27.6, 1e3])
acts("relative_motion", DUT, lambda d, p: 1 - 1e-8 * p[0] * d.payload * d.f ** 2, [[1.0]], 0.0, 1e4)
acts("transverse_motion", DUT, lambda d, p: 1 + (p[0] + p[2] * resonance(d.f, p[3], p[4])) * np.cos(d.turn - p[1]),
     [[0.005, b, 0.005, fr, 10] for b in (0, 1.6, 3.1, 4.7) for fr in (800, 3000)],
     [-0.3, -10, -0.3, 20, 0.7], [0.3, 10, 0.3, 6e4, 300])
acts("base_strain", DUT, lambda d, p: 1 + p[0] * (d.payload / 0.04) / (1 + (d.f / p[1]) ** 2), grid([0.005], 30), [-0.3, 5], [0.3, 200])
acts("gravity_tilt", DUT, lambda d, p: 1 + p[0] * np.cos(d.turn) / d.f ** 2, [[0.1]], -1e4, 1e4)
acts("dut_frequency_slope", DUT, lambda d, p: 1 - p[0] * np.log10(d.f / 160), [[0.01]], 0.0, 0.3)
acts("dut_temperature", DUT, lambda d, p: 1 + p[0] * d.warm, [[1e-3]], -0.05, 0.05)
acts("reference_temperature", REF, lambda d, p: 1 + p[0] * d.warm, [[1e-3]], -0.05, 0.05)
acts("reference_drift", REF, lambda d, p: 1 + 1e-6 * p[0] * d.time, [[1.0]], -1e4, 1e4)
acts("dut_drift", DUT, lambda d, p: 1 + 1e-6 * p[0] * d.time, [[1.0]], -1e4, 1e4)
acts("dut_highpass", DUT, lambda d, p: highpass(d.f, p[0]), grid([0.1, 1.0]), 1e-5, 1e3)
acts("reference_highpass", REF, lambda d, p: highpass(d.f, p[0]), grid([0.1, 1.0]), 1e-5, 1e3)
acts("dut_lowpass_1", DUT, lambda d, p: 1 / (1 + 1j * d.f / np.exp(p[0])), grid(np.log([2e4, 2e5])), 4.6, 20.7)
acts("dut_lowpass_2", DUT, lambda d, p: resonance(d.f, np.exp(p[0]), p[1]), grid(np.log([2e4, 1e5]), 0.7), [4.6, 0.5], [16, 1.1])
acts("averaging_window", DUT, lambda d, p: np.sinc(d.f * p[0]) * np.exp(-1j * np.pi * d.f * p[0]), [[1e-6], [2e-5]], 1e-9, 0.1)
acts("crosstalk", DUT, lambda d, p: 1 + 1j * d.f * 1e-6 * p[0] + p[1] + 1j * p[2], [[0.1, 0, 0], [0, 0, 0.01]], [-1e3, -0.5, -0.5], [1e3, 0.5, 0.5])
acts("channel_skew", DUT, lambda d, p: np.exp(-2e-6j * np.pi * d.f * p[0]), [[0.1]], -1e3, 1e3)
acts("clock_offset", DUT, lambda d, p: np.exp(2e-9j * np.pi * d.f * p[0] * d.time), [[0.1]], -1e7, 1e7)


@effect([[1e-4, 0.0]], [-0.1, -0.1], [0.1, 0.1])
def dut_level_nonlinearity(s, d, p):
    s.gain[DUT] = s.gain[DUT] * (1 + p[0] * d.level)
    s.h2 = p[1] * d.level


@effect([[5.0, 1e-3], [15.0, 1e-3]], [0.5, 0], [300, 3])
def loose_mount(s, d, p):
    def cut(volts):
        least = -p[0] * d.s2
        return np.maximum(volts, least)
    s.curves.append((DUT, cut))
    s.added[DUT] = s.added[DUT] + (d.s2 * p[1] * (d.level * np.sqrt(2) > p[0])) ** 2


@effect([[1e-4]], 0, 1)
def mains_pickup(s, d, p):
    s.added[DUT] = s.added[DUT] + p[0] ** 2


@effect([[0.1]], 0, 1e6)
def sampling_jitter(s, d, p):
    slope = d.w * 1e-6 * p[0]
    for channel, s0 in ((REF, d.s1), (DUT, d.s2)):
        s.gain[channel] = s.gain[channel] * np.exp(-0.5 * slope ** 2)
        s.added[channel] = s.added[channel] + (slope * d.level * s0) ** 2


@effect([[0.01]], 0, 10)
def ambient_vibration(s, d, p):
    for channel, s0 in ((REF, d.s1), (DUT, d.s2)):
        s.added[channel] = s.added[channel] + (p[0] * s0) ** 2


def converter(name, curve, starts, lower, upper):
    for channel, end in ((REF, "reference"), (DUT, "device")):
        def function(s, d, p, channel=channel):
            s.curves.append((channel, lambda volts: curve(volts, p)))
        function.__name__ = f"{name} {end}"
        effect(starts, lower, upper)(function)


converter("adc_cubic", lambda x, p: x + p[0] * x ** 3, [[1e-3]], -0.5, 0.5)
converter("adc_quadratic", lambda x, p: x + p[0] * x ** 2, [[1e-3]], -0.5, 0.5)
converter("adc_dead_zone", lambda x, p: x - np.clip(x, -p[0], p[0]), [[1e-4]], 0, 1)
converter("adc_clipping", lambda x, p: np.clip(x, -p[0], p[0]), [[1.3], [0.7], [0.4], [0.2]], 1e-4, 100)


def exciter(name, starts, lower, upper, change, bent=False):
    def function(s, d, p):
        change(s, d, p)
        s.bent = s.bent or bent
    function.__name__ = name
    effect(starts, lower, upper)(function)


def sets(attribute, scale=1.0):
    def change(s, d, p):
        setattr(s, attribute, getattr(s, attribute) + scale * p[0])
    return change


def asymmetry(s, d, p):
    s.k2 = s.k2 + 1e6 * p[0]
    s.k = s.k - 2 * s.k2 * s.m * 9.81 * d.up / s.k


def heating(s, d, p):
    s.r = s.r * (1 + 0.0039 * p[0] * (1 - np.exp(-d.time / p[1])))


def mode(s, d, p):
    q = d.f / p[1]
    s.motion = s.motion * (1 + p[0] * q ** 2 / (1 - q ** 2 + 2j * p[2] * q))


exciter("suspension_cubic", [[1.0], [100.0]], -1e8, 1e8, sets("k3", 1e6), True)
exciter("suspension_asymmetry", [[0.1]], -1e4, 1e4, asymmetry, True)
exciter("force_factor_droop", [[1e4], [1e5]], 0, 1e9, sets("droop"), True)
exciter("coulomb_friction", [[0.01], [0.1]], 0, 100, sets("friction"), True)
exciter("amplifier_even_order", [[1e-3]], -1, 1, sets("even"), True)
exciter("mechanical_damping", [[1.0]], -1e3, 1e4, sets("c"))
exciter("back_emf", [[0.05]], -0.95, 10, sets("emf"))
exciter("payload_mass", [[0.002]], -10, 100, sets("m"))
exciter("lossy_inductance", [[-0.2]], -0.7, 0, sets("exponent"))
exciter("coil_heating", [[10, 500], [10, 5000]], [0, 1], [300, 1e5], heating)
exciter("armature_mode", [[0.1, f, 0.02] for f in (3e3, 6e3, 12e3)], [-3, 1e3, 5e-4], [3, 4e4, 0.7], mode)


@effect([[20.0], [8.0], [3.0]], 1e-3, 1e4)
def amplifier_clipping(s, d, p):
    s.limit, s.bent = p[0], True


@effect([[1.0]], -1e4, 1e4)
def amplifier_gain_drift(s, d, p):
    s.amplifier = s.amplifier * (1 + 1e-6 * p[0] * d.time)


def balance(s, d, memory):
    """Voltage, current (peak, complex, for acceleration 1 + 0j) and harmonics of the acceleration."""
    w = d.w[:, None]
    n = np.arange(ORDERS + 1)
    nw = n * w
    a1 = np.sqrt(2) * d.level
    x = memory.get("x")
    if x is None:
        x = np.zeros((len(d.f), ORDERS + 1), complex)
    x[:, 1] = -a1 / d.w ** 2
    z = s.impedance(nw)
    z[:, 0] = s.r
    inertia = s.k[:, None] + 1j * nw * s.c[:, None] - nw ** 2 * s.m[:, None]
    bl = s.bl[:, None]
    linear = z * inertia / bl + 1j * nw * bl * s.emf[:, None]

    def time_of(lines):
        return np.fft.irfft(np.concatenate([lines[:, :1], lines[:, 1:] / 2], 1), POINTS) * POINTS

    def lines_of(values):
        lines = np.fft.rfft(values)[:, :ORDERS + 1] / POINTS
        lines[:, 1:] *= 2
        return lines

    for _ in range(30):
        xt, vt = time_of(x), time_of(1j * nw * x)
        force = time_of(inertia * x) + s.k2 * xt ** 2 + s.k3 * xt ** 3
        if s.friction:
            force = force + s.friction * np.tanh(vt / (1e-3 * a1 / d.w)[:, None])
        factor = bl * (1 - s.droop * xt ** 2)
        current = lines_of(force / factor)
        volts = z * current + lines_of(factor * s.emf[:, None] * vt)
        if s.limit < np.inf or s.even:
            size = np.abs(volts[:, 1])
            turn = np.exp(1j * np.angle(volts[:, 1]))[:, None] ** n
            if s.even:
                shape = lines_of(size[:, None] * COSINE + s.even * (size[:, None] * COSINE) ** 2)
            else:
                drive = size.copy()
                for _ in range(8):
                    shape = lines_of(np.clip(drive[:, None] * COSINE, -s.limit, s.limit))
                    drive = drive * np.minimum(size / np.maximum(np.abs(shape[:, 1]), 1e-12), 3.0)
            wanted = shape * turn
            wanted[:, 1] = volts[:, 1]
        else:
            wanted = np.zeros_like(volts)
            wanted[:, 1] = volts[:, 1]
        miss = volts - wanted
        miss[:, 0] = miss[:, 0].real
        x = x - miss / linear
        x[:, 1] = -a1 / d.w ** 2
        if np.max(np.abs(miss[:, 2:]) / np.abs(volts[:, 1:2])) < 1e-7:
            break
    memory["x"] = x
    harmonics = -(nw ** 2) * x / a1[:, None]
    return volts[:, 1] / a1, current[:, 1] / a1, harmonics[:, 2:6]


def predict(d, theta, chosen, memory):
    """All data for nuisances and [(name, parameters), ...]."""
    s = State(d, theta)
    for name, parameters in chosen:
        EFFECTS[name][0](s, d, parameters)
    jw = 1j * d.w
    if s.bent:
        volts, amps, h = balance(s, d, memory)
    else:
        z, inertia = s.impedance(d.w), s.m * jw ** 2 + s.c * jw + s.k
        amps = inertia / jw ** 2 / s.bl
        volts = z * amps + s.bl * s.emf / jw
        h = np.zeros((len(d.f), 4), complex)
    harmonics, dc, loss = [h.copy(), h + 0], [0 * d.f, 0 * d.f], list(s.gain)
    harmonics[DUT][:, 0] += s.h2
    for channel, curve in s.curves:
        peak = np.sqrt(2) * d.level * (d.s1, d.s2)[channel]
        lines = np.fft.rfft(curve(peak[:, None] * COSINE))[:, :6] / POINTS
        lines[:, 1:] *= 2
        dc[channel] = dc[channel] + lines[:, 0].real
        loss[channel] = loss[channel] * lines[:, 1] / peak
        harmonics[channel] += (lines[:, 2:6].T / lines[:, 1]).T
    ratio = loss[DUT] / loss[REF] * d.s2 / d.s1
    drive = d.s1 * loss[REF] * s.motion / volts
    runs = d.run.max() + 1
    gain = d.units * theta
    of_ref, of_dut = gain[8:8 + runs][d.run], gain[8 + runs:8 + 2 * runs][d.run]
    out = [np.log(np.abs(ratio)) + gain[0] - of_ref + of_dut, np.angle(ratio)]
    out += [np.log(np.abs(drive * s.amplifier)) + gain[1] + of_ref, np.angle(drive)]
    impedance = amps / volts
    out += [np.log(np.abs(impedance)), np.angle(impedance)]
    for channel in (REF, DUT):
        for n in range(4):
            out += [harmonics[channel][:, n].real, harmonics[channel][:, n].imag]
    out += dc
    for channel in (REF, DUT):
        healthy = (d.noise * np.exp(gain[-2 + channel])) ** 2
        out.append(0.5 * np.log(healthy + s.added[channel] + 0 * d.f))
    return np.array(out)


def whitened(d, prediction):
    left = d.data - prediction
    phases = left[1:6:2]
    left[1:6:2] = phases - 2 * np.pi * np.round(phases / (2 * np.pi))
    return (left / d.u).ravel()


class Fit:
    """Nuisances and parameters of a set at its least squares."""

    def __init__(self, d, names, theta, parameters, steps):
        self.names = names
        counts = [len(p) for p in parameters]
        ends = np.cumsum([len(theta), *counts])
        memory = {}

        def split(values):
            parts = [values[a:b] for a, b in zip(ends[:-1], ends[1:])]
            return values[:len(theta)], list(zip(names, parts))

        def residual(values):
            at, chosen = split(values)
            return np.concatenate([whitened(d, predict(d, at, chosen, memory)), -d.prior * at])

        def slopes(values):
            at, chosen = split(values)
            columns = nuisance_slopes(d, at, [c for c in chosen if not bends(c[0])])
            columns = np.vstack([columns, -np.diag(d.prior)])
            here = residual(values)
            for index in range(len(theta), len(values)):
                there = values.copy()
                # Away from the nearer bound.
                step = 1e-4 * max(abs(values[index]), 1e-3)
                step = -step if values[index] + step > upper[index] else step
                there[index] += step
                columns = np.column_stack([columns, (residual(there) - here) / step])
            return columns

        free = np.full(len(theta), 50.0)
        lower = np.concatenate([-free, *[EFFECTS[n][2] for n in names]])
        upper = np.concatenate([free, *[EFFECTS[n][3] for n in names]])
        start = np.clip(np.concatenate([theta, *parameters]), lower + 1e-12, upper - 1e-12)
        found = least_squares(residual, start, slopes, (lower, upper), x_scale="jac", max_nfev=steps)
        self.theta, self.chosen = split(found.x)
        self.square = 2 * found.cost
        self.bic = self.square + (sum(counts) + 2 * len(names)) * np.log(d.data.size)


def bends(name):
    return name in ("suspension_cubic", "suspension_asymmetry", "force_factor_droop", "coulomb_friction",
                    "amplifier_even_order", "amplifier_clipping")


def nuisance_slopes(d, theta, chosen):
    """Slopes of the residual against the nuisances; of a bent exciter those of the straight one."""
    base = whitened(d, predict(d, theta, chosen, {}))
    columns = []
    for index in range(len(theta)):
        there = theta.copy()
        there[index] += 1e-3
        columns.append((whitened(d, predict(d, there, chosen, {})) - base) / 1e-3)
    return np.array(columns).T


def promises(d, fit):
    """Every start of every effect beside a fit: gain expected, name, parameters; best first."""
    straight = [c for c in fit.chosen if not bends(c[0])]
    tangent = np.vstack([nuisance_slopes(d, fit.theta, straight), -np.diag(d.prior)])
    basis, _ = np.linalg.qr(tangent)
    pad = np.zeros(len(fit.theta))
    here = whitened(d, predict(d, fit.theta, fit.chosen, {}))
    residual = np.concatenate([here, -d.prior * fit.theta])
    residual = residual - basis @ (basis.T @ residual)
    found = {}
    for name, (_, starts, lower, _) in EFFECTS.items():
        if name in fit.names:
            continue
        for start in starts:
            there = whitened(d, predict(d, fit.theta, fit.chosen + [(name, start)], {}))
            change = np.concatenate([here - there, pad])
            change = change - basis @ (basis.T @ change)
            size = change @ change
            if size == 0 or not np.isfinite(size):
                continue
            scale = change @ residual / size
            gain = scale * (change @ residual)
            if scale < 0 and lower[0] >= 0:
                gain = 0.0
            whole = residual @ residual - (residual - change) @ (residual - change)
            best = found.get(name, (-np.inf,))
            if max(gain, whole) > best[0]:
                parameters = np.array(start, float)
                if gain > whole and lower[0] <= 0:
                    parameters[0] *= scale
                found[name] = (max(gain, whole), name, parameters)
    return sorted(found.values(), key=lambda p: -p[0])


def diagnose(folder):
    d = Dataset(folder)
    nominal = Fit(d, [], np.zeros(len(d.units)), [], 20)
    fits = [nominal]
    singles = []
    for gain, name, start in promises(d, nominal)[:SIDE]:
        if gain > 5:
            singles.append(Fit(d, [name], nominal.theta, [start], 25))
    singles.sort(key=lambda fit: fit.square)
    fits += singles
    tried = set()
    for base in singles[:BASES]:
        grown = 0
        for gain, name, start in promises(d, base):
            names = frozenset([*base.names, name])
            if gain < 9 or grown == GROWN:
                break
            if names in tried:
                continue
            tried.add(names)
            grown += 1
            parameters = [p for _, p in base.chosen]
            fits.append(Fit(d, [*base.names, name], base.theta, [*parameters, start], 25))
    best = min(fits, key=lambda fit: fit.bic)
    return {"first": sorted(n.split()[0] for n in best.names), "bic": best.bic - nominal.bic, "fits": len(fits)}


def main():
    np.seterr(all="ignore")
    for folder in sys.argv[1:]:
        begun = time.process_time()
        try:
            answer = diagnose(folder)
        except (ValueError, np.linalg.LinAlgError) as error:
            # A fit that meets no finite number is a wrong answer, not the end.
            answer = {"first": ["failed"], "error": str(error)}
        answer["seconds"] = time.process_time() - begun
        print(json.dumps(answer), flush=True)


main()
