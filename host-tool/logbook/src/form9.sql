-- Keys that instruments have in place of the one before, since their memory was erased or their board changed: in
-- which series of record numbers, and why, as a person said. Records of before stay with the key of before.
CREATE TABLE later_keys (
    instrument TEXT NOT NULL,
    series INTEGER NOT NULL CHECK (series > 0),
    public BLOB NOT NULL,
    since INTEGER NOT NULL,
    reason TEXT NOT NULL,
    stated_s INTEGER NOT NULL,
    PRIMARY KEY (instrument, series),
    UNIQUE (instrument, public)
) STRICT, WITHOUT ROWID;
CREATE TRIGGER later_keys_stay BEFORE UPDATE ON later_keys
BEGIN SELECT RAISE(ABORT, 'a key of an instrument is not changed'); END;
CREATE TRIGGER later_keys_are_kept BEFORE DELETE ON later_keys
BEGIN SELECT RAISE(ABORT, 'a key of an instrument is not removed'); END;
-- With each key an instrument counts its records anew.
ALTER TABLE records ADD COLUMN series INTEGER NOT NULL DEFAULT 0;
CREATE INDEX records_by_number ON records (instrument, series, number);
