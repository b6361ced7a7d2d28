-- Times are seconds since 1970-01-01 UTC, days are ISO 8601, sums are SHA-256.
CREATE TABLE sensors (
    serial TEXT PRIMARY KEY,
    manufacturer TEXT NOT NULL,
    model TEXT NOT NULL,
    sensitivity_v_per_ms2 REAL,
    range_ms2 REAL,
    iepe INTEGER,
    mounting TEXT,
    owner TEXT,
    due_day TEXT,
    teds BLOB
) STRICT;

CREATE TABLE records (
    id INTEGER PRIMARY KEY,
    sha256 BLOB NOT NULL UNIQUE,
    instrument TEXT NOT NULL,
    number INTEGER NOT NULL,
    unix_time_s INTEGER NOT NULL,
    sensor_serial TEXT NOT NULL,
    sensor_model TEXT NOT NULL,
    operator TEXT NOT NULL,
    complete INTEGER NOT NULL,
    points INTEGER NOT NULL,
    refused INTEGER NOT NULL,
    reference_frequency_hz REAL,
    sensitivity_v_per_ms2 REAL,
    expanded_uncertainty_rel REAL
) STRICT;
CREATE INDEX records_by_time ON records (unix_time_s);
CREATE INDEX records_by_sensor ON records (sensor_serial, unix_time_s);

-- Apart from the list, so that a list need not read past them.
CREATE TABLE contents (
    record INTEGER PRIMARY KEY REFERENCES records (id),
    bytes BLOB NOT NULL
) STRICT;

CREATE TABLE points (
    record INTEGER NOT NULL REFERENCES records (id),
    position INTEGER NOT NULL,
    frequency_hz REAL NOT NULL,
    acceleration_rms_ms2 REAL NOT NULL,
    verdict TEXT NOT NULL,
    sensitivity_v_per_ms2 REAL,
    expanded_uncertainty_rel REAL,
    coverage_factor REAL,
    phase_rad REAL,
    expanded_uncertainty_phase_rad REAL,
    PRIMARY KEY (record, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE operators (
    name TEXT PRIMARY KEY,
    first_s INTEGER NOT NULL,
    last_s INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE instruments (
    serial TEXT PRIMARY KEY,
    firmware TEXT NOT NULL,
    reference_serial TEXT NOT NULL,
    reference_certificate TEXT NOT NULL,
    due_day TEXT,
    reference_table TEXT NOT NULL,
    last_s INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE certificates (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    certificate TEXT NOT NULL,
    format TEXT NOT NULL,
    record_sha256 BLOB NOT NULL,
    issued_s INTEGER NOT NULL,
    file TEXT NOT NULL,
    sha256 BLOB NOT NULL,
    UNIQUE (certificate, format)
) STRICT;
CREATE TRIGGER certificates_stay BEFORE UPDATE ON certificates
BEGIN SELECT RAISE(ABORT, 'an issued certificate is not changed'); END;
CREATE TRIGGER certificates_are_kept BEFORE DELETE ON certificates
BEGIN SELECT RAISE(ABORT, 'an issued certificate is not removed'); END;
