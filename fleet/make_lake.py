"""A lake of many laboratories with known truth: what drifts, and who is out, is drawn and told.

Same tables, columns and folders as `calib export --lake` writes, so that a fleet of any size can be tried.
"""

import argparse
import hashlib
import json
from pathlib import Path

import numpy

START_S = 1_577_836_800  # 2020-01-01 UTC
YEAR_S = 31_557_600
#: U (k = 2) of a result, relative, and the standard deviation of its repetition.
U_REL, REPEAT_REL = 8e-3, 1e-3


def drawn(records, seed):
    """Every result with its cause: columns by name, and the truth."""
    random = numpy.random.default_rng(seed)
    instruments, devices = max(records // 500, 6), max(records // 100, 12)
    standards = 3
    reference_drift = random.normal(0, 1e-3, instruments)
    out = random.choice(instruments, max(instruments // 50, 1), replace=False)
    bias = random.normal(0, U_REL / 6, instruments)
    bias[out] += random.choice([-1, 1], out.size) * 4 * U_REL
    drift = random.normal(0, 2e-3, devices)
    # Two of three results are of devices at home, the others of standards that travel.
    instrument = random.integers(instruments, size=records)
    travels = random.random(records) < 1 / 3
    home = random.integers(devices, size=records)
    home -= (home - instrument) % min(instruments, devices)
    device = numpy.where(travels, -1 - random.integers(standards, size=records), home % devices)
    seconds = numpy.sort(random.integers(0, 5 * YEAR_S, size=records))
    years = seconds / YEAR_S
    change = numpy.where(travels, 0.0, drift[numpy.clip(device, 0, None)] * years)
    # A reference that gives more than its certificate says makes what is measured look less.
    shown = (1 + change) * (1 + bias[instrument]) / (1 + reference_drift[instrument] * years)
    shown *= 1 + random.normal(0, REPEAT_REL, records)
    serial = numpy.where(travels, numpy.char.add("CHECK-", (-device).astype(str)), numpy.char.add("D-", device.astype(str)))
    columns = {
        "record_sha256": [hashlib.sha256(f"{seed}/{n}".encode()).hexdigest() for n in range(records)],
        "instrument_serial": numpy.char.add("I-", instrument.astype(str)),
        "laboratory": numpy.char.add("Lab ", (instrument % max(instruments // 20, 2)).astype(str)),
        "seconds": seconds + START_S,
        "dut_serial": serial,
        "dut_model": numpy.where(travels, "standard", numpy.char.add("M-", (device % 20).astype(str))),
        "sensitivity_v_per_ms2": 0.01 * shown,
    }
    truth = {
        "outliers": sorted(f"I-{n}" for n in out),
        "reference_drift_rel_per_year": {f"I-{n}": float(value) for n, value in enumerate(reference_drift)},
        "drift_rel_per_year": {f"D-{n}": float(value) for n, value in enumerate(drift)},
    }
    return columns, truth


TABLES = {
    "records": """SELECT record_sha256, instrument_serial, row_number() OVER () AS record_id, time, 'calibration' AS kind,
        dut_serial, dut_model, 'N. N.' AS operator, true AS complete, 10::BIGINT AS points, 0::BIGINT AS refused,
        160.0::DOUBLE AS reference_frequency_hz, sensitivity_v_per_ms2, {u}::DOUBLE AS expanded_uncertainty_rel""",
    "points": """SELECT record_sha256, instrument_serial, time, dut_serial, dut_model, 'N. N.' AS operator,
        position, 20.0 * 2 ** position AS frequency_hz, 10.0::DOUBLE AS set_acceleration_rms_ms2, 'valid' AS state,
        NULL::VARCHAR AS reason_text, sensitivity_v_per_ms2 * (1 + 1e-4 * position) AS sensitivity_v_per_ms2,
        {u}::DOUBLE AS expanded_uncertainty_rel, 2.0::DOUBLE AS coverage_factor, -0.1::DOUBLE * position AS phase_deg,
        0.5::DOUBLE AS expanded_uncertainty_phase_deg""",
    "settings": """SELECT record_sha256, instrument_serial, time, 'reference.sensitivity_v_per_ms2' AS key,
        0.01::DOUBLE AS value_number, NULL::VARCHAR AS value_text""",
    "budgets": """SELECT record_sha256, instrument_serial, time, 1::BIGINT AS row, {u}::DOUBLE AS value_rel,
        'normal' AS distribution, 2.0::DOUBLE AS divisor, 1.0::DOUBLE AS sensitivity_coefficient,
        {u} / 2::DOUBLE AS contribution_rel, NULL::DOUBLE AS degrees_of_freedom""",
    "checks": """SELECT record_sha256, instrument_serial, time, dut_serial AS check_serial, 30::BIGINT AS every_days,
        160.0::DOUBLE AS frequency_hz, 'valid' AS state, sensitivity_v_per_ms2, {u}::DOUBLE AS expanded_uncertainty_rel,
        0.01::DOUBLE AS certified_v_per_ms2, 2e-3::DOUBLE AS certified_expanded_uncertainty_rel""",
}


def make(lake, records, seed=1):
    """Writes the lake, and returns the truth."""
    import duckdb
    import pyarrow

    columns, truth = drawn(records, seed)
    Path(lake).mkdir(parents=True, exist_ok=True)
    connection = duckdb.connect()
    connection.register("drawn", pyarrow.table({name: pyarrow.array(list(values)) for name, values in columns.items()}))
    connection.execute(
        "CREATE TABLE results AS SELECT *, to_timestamp(seconds) AS time,"
        " instrument_serial AS instrument, year(to_timestamp(seconds) AT TIME ZONE 'UTC') AS year FROM drawn"
    )
    connection.execute("SET preserve_insertion_order = false")
    for table, select in TABLES.items():
        rows = ", range(10) AS of_list(position)" if table == "points" else ""
        only = " WHERE dut_model = 'standard'" if table == "checks" else ""
        connection.execute(
            f"COPY ({select.format(u=U_REL)}, laboratory, instrument, year FROM results{rows}{only}) TO '{lake}/{table}'"
            " (FORMAT parquet, PARTITION_BY (laboratory, instrument, year))"
        )
    return truth


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lake", type=Path)
    parser.add_argument("--records", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    told = make(asked.lake, asked.records, asked.seed)
    (asked.lake.parent / f"{asked.lake.name}-truth.json").write_text(json.dumps(told), encoding="utf-8")
