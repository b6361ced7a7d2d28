"""From nothing to a certificate and a first diagnosis, without hardware."""

from pathlib import Path

import calib

with calib.connect("emulated") as instrument:
    print(instrument.info().firmware_version, instrument.info().instrument_serial)
    run = instrument.run([80, 160], level=10.0, serial="SN1", model="demo", on_point=lambda p: print(p.frequency_hz, "Hz"))
for point in run.record.points:
    print(f"S({point.frequency_hz:g} Hz) = {1e3 * point.sensitivity_v_per_ms2:.4f} mV/(m/s2)")
print(*run.record.certificate("out"), sep="\n")

dataset = calib.gap.simulate("standard", "suspension_cubic=k3_n_per_m3:1e7", out="dataset", seed=7)
answer = calib.gap.diagnose(dataset)
print(answer.verdict, answer.effects(), answer.summary)
assert answer.verdict == "explained" and answer.effects() == ["suspension_cubic"]
assert Path("out").is_dir() and run.state == "finished"
