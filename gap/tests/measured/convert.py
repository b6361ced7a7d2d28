"""Measured sets of known cause from public repositories, as datasets of points.

    python3 convert.py CLONES OUT

CLONES holds a clone of each repository of SOURCES, named OWNER+NAME. Each set is read from the stated
commit and written to OUT/developed or OUT/kept with rig.toml, points.csv and cause.txt; the SHA-256 of
every points.csv has to be the one in SHA256SUMS, which was committed before the set was diagnosed for the
first time. `./run bench measured OUT/kept` diagnoses them. The data are no part of the repository.

Nothing states an uncertainty for most of them: u is what the reading of such an instrument resolves.
"""

import hashlib
import math
import subprocess
import sys
from pathlib import Path

EPRAK = ("tooncesthecat", "uni_mitschriften", "3bcc4ee43a63fd76c89173643aa79bff96572bbf")
E7 = ("HCui91", "E7-LRC", "ab9bc73b7cd7f1d896ff3d0f81d9788d37bf674e")
ECLAB = ("Swaraj528", "ECLab2025", "91f9c47deaddcf3279241da9d4121388be8f3f72")
MATAA = ("mbrennwa", "mataa", "827143f791a033a95739947a498b471a32312ef7")

RIG = 'kind = "calibrator"\nmeasurand = "dut_sensitivity"\n'


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
        show = ["git", "--git-dir", str(found), "show", f"{commit}:{file}"]
        text = subprocess.run(show, check=True, capture_output=True).stdout.decode("latin-1")
        points = "\n".join(reader(text)) + "\n"
        digest = hashlib.sha256(points.encode()).hexdigest()
        if stated.get(name) != digest:
            print(f"{digest} {name}: not what SHA256SUMS states")
            failed = True
        folder = Path(out) / ("kept" if kept else "developed") / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "points.csv").write_text(points)
        (folder / "rig.toml").write_text(RIG)
        (folder / "cause.txt").write_text(cause + "\n")
        (folder / "known.txt").write_text(known + "\n")
    sys.exit(int(failed))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
