-- Public keys of instruments (Ed25519), and the first record each signed.
CREATE TABLE keys (
    instrument TEXT PRIMARY KEY,
    public BLOB NOT NULL,
    since INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
-- Check standards: sensors that are measured for no customer, how often, at which frequency they are compared,
-- and what their own certificate says of them there.
CREATE TABLE check_standards (
    serial TEXT PRIMARY KEY,
    frequency_hz REAL NOT NULL,
    every_days INTEGER NOT NULL,
    certified_v_per_ms2 REAL,
    certified_expanded_uncertainty_rel REAL
) STRICT;
