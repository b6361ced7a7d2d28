"""Measured sets of known cause from public repositories, as datasets of points or records.

    python3 convert.py CLONES OUT

CLONES holds a clone of each repository of SOURCES, named OWNER+NAME. Each set is read from the stated
commit and written to OUT/developed or OUT/kept with rig.toml, points.csv or record.csv, and cause.txt; the
SHA-256 of every table has to be the one in SHA256SUMS, which was committed before the set was diagnosed for
the first time. `./run bench measured OUT/kept` diagnoses them. The data are no part of the repository.

Nothing states an uncertainty for most of them: u is what the reading of such an instrument resolves.
"""

import bisect
import hashlib
import io
import math
import re
import subprocess
import sys
import zipfile
from pathlib import Path

EPRAK = ("tooncesthecat", "uni_mitschriften", "3bcc4ee43a63fd76c89173643aa79bff96572bbf")
E7 = ("HCui91", "E7-LRC", "ab9bc73b7cd7f1d896ff3d0f81d9788d37bf674e")
ECLAB = ("Swaraj528", "ECLab2025", "91f9c47deaddcf3279241da9d4121388be8f3f72")
MATAA = ("mbrennwa", "mataa", "827143f791a033a95739947a498b471a32312ef7")

# The second collection; the licence is in brackets where the repository states one.
SPEAKERBENCH = ("jcandy", "speakertools", "66461987090a293edb606ee13b9d1d6996747737")
ELAC = ("yankz12", "audiolib-elac", "c531e35ea01834fc71399762ec5eb4143012ff59")  # [GPL-3.0]
MET4FOF = ("Met4FoF", "datareceiver", "174762d78211fb1292354b4bc662ec8464394812")
SIGCAL = ("tychoaussie", "Sigcal_v1", "45bcb645a9e459b41125b731997e90410be73b31")  # [MIT]
WHEEL = ("HeiLaut", "resonance_pendulum", "f73a07760be569b8d41d9b5bac0c3506bd7f567f")  # [MIT]
DISC = ("filo0509", "smorzamento", "d2a1b2f4e8baeaba8aa0ab9af652498b50cd9ab8")  # [MIT]
BOB = ("DavidW99", "Damping_Oscillator", "5b8248c9a5332dd44c85579cec5d2ac8079df02c")
# [MIT]
ENCODER = ("jensen-benard", "rotary-inverted-pendulum", "1f3bb8046d5af4cc32c2965cad34336f1e13e43a")
# [BSD-3-Clause]
MOTOR = ("dfki-ric-underactuated-lab", "torque_limited_simple_pendulum",
         "ed17ea2d32a35ad944944ca03ef57693e2986732")
DAISY = ("Rafa7046", "Non_Linear_Identification", "e5c9b006b0a2ec1650bc018a5fb38d2f4363d4c7")

RIG = 'kind = "calibrator"\nmeasurand = "dut_sensitivity"\n'

# Values that the sources state of a rig, with a tenth of it as u; orders of magnitude where they state nothing.
LOUDSPEAKER = """kind = "calibrator"
measurand = "drive"
[exciter]
moving_mass_kg = {{ value = {}, u = {} }}
stiffness_n_per_m = {{ value = {}, u = {} }}
damping_ns_per_m = {{ value = {}, u = {} }}
force_factor_n_per_a = {{ value = {}, u = {} }}
coil_resistance_ohm = {{ value = {}, u = {} }}
coil_inductance_h = {{ value = {}, u = {} }}
"""
RECORD = 'kind = "oscillator"\n'
OSCILLATOR = RECORD + """[oscillator]
resonance_hz = {{ value = {}, u = {} }}
delta = {{ value = {}, u = {} }}
"""
RIGS = {
    "loudspeaker_l16rnx": LOUDSPEAKER.format(
        0.0149, 0.0015, 1190, 119, 2.11, 0.5, 7.01, 0.7, 5.72, 0.57, 5e-4, 3e-4
    ),
    "loudspeaker_ls10": LOUDSPEAKER.format(0.2, 0.2, 5e3, 5e3, 5, 5, 15, 10, 7, 3, 3e-3, 3e-3),
    "mass_spring_disc": OSCILLATOR.format(1.369, 0.014, 0.005, 0.005),
    "pendulum_bob": OSCILLATOR.format(0.8625, 0.02, 0.01, 0.01),
    "pendulum_encoder": RECORD,
    "pendulum_motor": OSCILLATOR.format(0.637, 0.064, 0.094, 0.05) + "rho = { value = 16.0, u = 1.6 }\n",
    "robot_arm": RECORD,
}


def numbers(text, split=None):
    """Rows of numbers; other lines are comments."""
    for line in text.splitlines():
        cells = [cell for cell in (line.split(split) if split else line.split()) if cell.strip()]
        try:
            row = [float(cell) for cell in cells]
        except ValueError:
            continue
        if row:
            yield row


def scope(text, turned_deg=0.0):
    """Bode plot of an oscilloscope: frequency, gain in dB, gain, phase. Its 8 bits resolve 2 % and 1.5
    degrees where the output is a fiftieth of the largest or more; below that the phase is noise."""
    rows = list(numbers(text))
    largest = max(row[2] for row in rows)
    yield "frequency_hz,ratio,dut_deg,u_ratio,u_phase_deg"
    for frequency_hz, _, gain, phase_deg in rows:
        if gain >= largest / 50.0:
            yield f"{frequency_hz},{gain},{(phase_deg + turned_deg + 180.0) % 360.0 - 180.0:.6f},0.02,1.5"


def peak_to_peak(text):
    """Frequency, volts peak to peak and their stated uncertainty, read from a screen."""
    yield "frequency_hz,ratio,u_ratio"
    for frequency_hz, volt, u_volt, *_ in numbers(text, ","):
        yield f"{frequency_hz},{volt},{u_volt / volt:.6f}"


def readings(text):
    """Frequency and gain, read from a screen to 2 %, down to a fiftieth of the largest."""
    rows = list(numbers(text, ","))
    yield "frequency_hz,ratio,u_ratio"
    for frequency_hz, gain, *_ in rows:
        if gain >= max(row[1] for row in rows) / 50.0:
            yield f"{frequency_hz},{gain},0.02"


def decibels(text):
    """Frequency and dB below 500 Hz, where the acoustics of a microphone are flat; to 0.05 dB."""
    yield "frequency_hz,ratio,u_ratio"
    for row in numbers(text):
        if len(row) == 2 and row[0] <= 500.0:
            yield f"{row[0]},{10.0 ** (row[1] / 20.0):.9f},{0.05 * math.log(10.0) / 20.0:.6f}"


def inverted(text):
    """An inverting amplifier, taken as one that does not invert."""
    return scope(text, 180.0)



def current(rows, payload_kg, u):
    """Current through an impedance in ohm and degrees, at one volt: it lags where the impedance leads."""
    for frequency_hz, ohm, deg in rows:
        yield f"{frequency_hz},{payload_kg},1.0,{1.0 / ohm:.9f},{-deg:.6f},{u}"


CURRENT = "frequency_hz,payload_kg,coil_v,coil_a,coil_a_deg,u_current"


def three_masses(bare, middle, heavy):
    """Impedance of a loudspeaker bare and with two masses on its cone, every third of its frequencies."""
    yield CURRENT
    for text, payload_kg in (bare, 0.0), (middle, 0.008017), (heavy, 0.016048):
        yield from current(list(numbers(text))[::3], payload_kg, 0.002)


def two_masses(bare, heavy):
    """Impedance of a loudspeaker bare and with 0.1 kg on its cone: of a spectrum in steps of half a hertz the
    rows nearest to twelfths of an octave."""
    yield CURRENT
    for text, payload_kg in (bare, 0.0), (heavy, 0.1):
        rows = [(f, ohm, math.degrees(rad)) for f, ohm, rad in numbers(text)]
        asked = [5.0 * 2.0 ** (k / 12.0) for k in range(120)]
        chosen = {min(range(len(rows)), key=lambda i: abs(rows[i][0] - f)) for f in asked}
        yield from current([rows[i] for i in sorted(chosen)], payload_kg, 0.005)


def sweeps(text):
    """Repeated sweeps of an accelerometer with a digital output, with the uncertainties their authors state."""
    yield "frequency_hz,run,acceleration_ms2,ratio,dut_deg,u_ratio,u_phase_deg"
    run, before_hz = 0, 0.0
    for _, hz, ratio, u, peak_ms2, rad, u_rad in numbers(text, ","):
        run, before_hz = run + (hz < before_hz), hz
        level = f"{peak_ms2 / math.sqrt(2.0):.6f}"
        phase = f"{math.degrees(rad):.6f},{u / ratio:.7f},{math.degrees(u_rad):.6f}"
        yield f"{hz:.4f},{run},{level},{ratio:.9f},{phase}"


def seismometer(text):
    """Sensitivity to velocity, computed once by integrating and once by deriving; u is by how far the two
    differ, and at least half a per cent."""
    yield "frequency_hz,ratio,u_ratio"
    for line in text.splitlines():
        cells = " ".join(re.split("[,\\t]", line)[:5])
        for frequency_hz, sensitivity, _, _, percent in numbers(cells):
            yield f"{frequency_hz},{sensitivity},{max(abs(percent) / 100.0, 0.005):.5f}"


def turning(text):
    """Period and amplitude of a wheel: the scale is read to 0.3, and half a per cent of the period is five
    per cent of the amplitude on the flanks of the resonance."""
    yield "frequency_hz,ratio,u_ratio"
    for period_s, amplitude in sorted(numbers(text, ","), reverse=True):
        yield f"{1.0 / period_s:.6f},{amplitude},{math.hypot(0.3 / amplitude, 0.05):.5f}"


def decay(interval_s, output):
    """A free decay: nothing drives it."""
    yield "time_s,input,output"
    for k, value in enumerate(output):
        yield f"{k * interval_s:.6f},0,{value:.7f}"


def sonar(text):
    """Position by an ultrasonic sensor, every 10 ms."""
    return decay(0.01, [position for _, position, *_ in numbers(text.replace(";", " "))])


def filmed(text):
    """Time and angle in degrees, read from a film of 30 pictures a second: a sheet of an .xlsx."""
    sheets = zipfile.ZipFile(io.BytesIO(text.encode("latin-1")))
    sheet = sheets.read("xl/worksheets/sheet1.xml").decode()
    degrees = re.findall('<c r="B[0-9]+"[^>]*><v>([^<]+)', sheet)
    return decay(1.0 / 30.0, [math.radians(float(value)) for value in degrees])


def counted(text):
    """Angle in degrees, a line each ms."""
    return decay(0.001, [math.radians(row[0]) for row in numbers(text) if len(row) == 1])


def motor(text):
    """Time, angle and torque; the clock skips now and then, so it is interpolated to even steps."""
    rows = list(numbers(text, ","))
    times = [row[0] for row in rows]
    step = (times[-1] - times[0]) / (len(times) - 1)
    yield "time_s,input,output"
    for k in range(len(times)):
        at = k * step
        after = min(max(bisect.bisect_right(times, at), 1), len(times) - 1)
        part = (at - times[after - 1]) / (times[after] - times[after - 1])
        angle, _, torque = [a + part * (b - a) for a, b in zip(rows[after - 1], rows[after])][1:]
        yield f"{at:.6f},{torque:.7f},{angle:.7f}"


def in_and_out(text):
    """Input and output; the interval is not stated, and taken as 10 ms."""
    yield "time_s,input,output"
    for k, (torque, acceleration) in enumerate(numbers(text, ",")):
        yield f"{k * 0.01:.2f},{torque},{acceleration}"


BODE_2 = "eprak/auswertungen/02/img/"
# name, source, file, reader, known cause, whether it was kept undiagnosed to the end, what is known
SETS = [
    ("rc_lowpass", EPRAK, BODE_2 + "2a_bode_tief.txt", scope, "dut_lowpass_1", False,
     "RC low-pass, 1592 Hz by its parts, 1656 Hz by its authors"),
    ("rlc_lowpass", EPRAK, BODE_2 + "bode_4a_mit_widerstand.txt", scope, "dut_resonance", False,
     "L 0.1 H, C 10 nF, 1 kilohm: 5033 Hz, quality 3.2 by its parts"),
    ("rlc_light", E7, "low_damp.csv", peak_to_peak, "dut_resonance", False,
     "18 mH, 1800 pF, 820 ohm: 27.96 kHz, quality 3.9 by its parts"),
    ("rc_one_stage", ECLAB, "experiment03/files/data.csv", readings, "dut_lowpass_1", False,
     "one RC stage; 8 readings"),
    ("amplifier", EPRAK, "eprak/auswertungen/03/img/bode/3_2_Bode_1.txt", inverted,
     "dut_highpass+dut_lowpass_1", False,
     "transistor amplifier with coupling capacitors and a limited bandwidth"),
    ("rc_highpass", EPRAK, BODE_2 + "2b_bode_hoch.txt", scope, "dut_highpass", True,
     "RC high-pass, 1592 Hz by its parts, 1656 Hz by its authors"),
    ("lc_lowpass", EPRAK, BODE_2 + "bode_4a.txt", scope, "dut_resonance", True,
     "the same without the resistor; that of the coil and the generator damp"),
    ("coaxial_cable", EPRAK, BODE_2 + "bode_5d.txt", scope, "channel_skew", True,
     "a long coaxial cable: a delay of about half a microsecond, and losses"),
    ("rlc_heavy", E7, "high_damp.csv", peak_to_peak, "dut_resonance", True,
     "18 mH, 1800 pF, 1520 ohm: 27.96 kHz, quality 2.1 by its parts"),
    ("rc_two_stages", ECLAB, "experiment03/files/data_2.csv", readings, "dut_lowpass_2", True,
     "two equal RC stages, 10 kilohm and 220 nF: 72.3 Hz, quality 1/3 by its parts"),
    ("microphone", MATAA, "calibration/ISEMCON_EMX7150_2391606-270916_MICROPHONE.txt", decibels,
     "dut_highpass", True, "vent and coupling capacitor of a measurement microphone"),
    # The second collection: kept are the second, fourth, ... of its names in alphabetical order.
    ("imu_mpu9250", MET4FOF, "tools/mpu9250_cal_results/MPU9250_PTB.csv", sweeps,
     "dut_lowpass_1|dut_lowpass_2|dut_lowpass_4|averaging_window|sinc2_filter", False,
     "digital low-pass of an MPU-9250, 218 Hz by its data sheet; calibrated by PTB in ten sweeps"),
    ("loudspeaker_l16rnx", SPEAKERBENCH,
     ("src/data/L16RNX_0g_242_27mV.zma", "src/data/L16RNX_8_017g_242_27mV.zma",
      "src/data/L16RNX_16_048g_242_27mV.zma"), three_masses,
     "lossy_inductance|shorted_inductance", True,
     "a woofer; its authors fit a semi-inductance in parallel with an inductance and a resistor, and a "
     "suspension that creeps, which the library lacked then"),
    ("loudspeaker_ls10", ELAC, ("test/test_impedance.txt", "test/test_impedance_added_mass.txt"),
     two_masses, "lossy_inductance|shorted_inductance", False,
     "a subwoofer with iron around its coil; its authors read the inductance between 500 and 1000 Hz only"),
    ("mass_spring_disc", DISC, "data_raw/molla_durissima_discopieno_14.91945_0.2016_1.csv", sonar,
     "quadratic_damping", True,
     "a spring of 14.9 N/m with 0.2016 kg and a disc across the motion, in air: its authors fit A/(1 + bAt) "
     "better than an exponential to its peaks"),
    ("pendulum_bob", BOB, "damping_angle.xlsx", filmed, "cubic_stiffness+quadratic_damping", False,
     "a wooden ball on a thread of 0.315 m let go at 56 degrees: g/l sin(x), and drag by its diameter"),
    ("pendulum_encoder", ENCODER,
     "software/modelling/experiment/damping_coefficient/pendulum_free_swing_data_01.txt", counted,
     "cubic_stiffness", True, "a rod with an encoder let go at 90 degrees: sin(x); its damping is not known"),
    ("pendulum_motor", MOTOR, "results/control_method_pd/system_identification/data_measured.csv", motor,
     "coulomb_friction+cubic_stiffness", False,
     "a pendulum on a motor swung up to the top; by its authors J 0.0626, m g l 1.00 N m, viscous 0.047, "
     "Coulomb 0.184 N m, offset -0.076 N m"),
    ("robot_arm", DAISY, "src/data/robot-arm.csv", in_and_out, "second_mode", True,
     "flexible robot arm of DaISy, torque to acceleration: resonances with antiresonances between"),
    ("seismometer_sm3", SIGCAL, "Sampledata/SM3_SN001/calibration_output_SN001.cal", seismometer,
     "dut_highpass_2", False, "a pendulum of 0.487 Hz and damping ratio 0.775 (quality 0.645) by its authors"),
    ("seismometer_vegik", SIGCAL, "Sampledata/vegik/calibration_output_vegik.cal", seismometer,
     "dut_highpass_2", True, "a pendulum of 0.998 Hz and damping ratio 0.535 (quality 0.935) by its authors"),
    ("torsion_wheel", WHEEL, "measurements/Rad_klein_feder_35.csv", turning, "dut_resonance", False,
     "a wheel on a spring driven by a crank, resonance near 1.3 Hz: below the 10 Hz the library begins at"),
]


def main(clones, out):
    stated = dict(line.split()[::-1] for line in (Path(__file__).parent / "SHA256SUMS").open())
    failed = False
    for name, (owner, repository, commit), file, reader, cause, kept, known in SETS:
        clone = Path(clones) / f"{owner}+{repository}"
        places = [clone / ".git", clone, clone / "repo/.git", clone / "repo"]
        found = next((place for place in places if (place / "HEAD").is_file()), None)
        if found is None:
            sys.exit(f"{clone}: no clone of https://github.com/{owner}/{repository}")
        files = (file,) if isinstance(file, str) else file
        show = ["git", "--git-dir", str(found), "show"]
        shown = [[*show, f"{commit}:{path}"] for path in files]
        texts = [subprocess.run(one, check=True, capture_output=True).stdout for one in shown]
        table = "\n".join(reader(*(text.decode("latin-1") for text in texts))) + "\n"
        digest = hashlib.sha256(table.encode()).hexdigest()
        if stated.get(name) != digest:
            print(f"{digest} {name}: not what SHA256SUMS states")
            failed = True
        folder = Path(out) / ("kept" if kept else "developed") / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / ("record.csv" if table.startswith("time_s") else "points.csv")).write_text(table)
        (folder / "rig.toml").write_text(RIGS.get(name, RIG))
        (folder / "cause.txt").write_text(cause + "\n")
        (folder / "known.txt").write_text(known + "\n")
    sys.exit(int(failed))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
