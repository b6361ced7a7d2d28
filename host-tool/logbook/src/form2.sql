-- The kind of a record, which was read from its bytes for every line of the list.
ALTER TABLE records ADD COLUMN kind TEXT NOT NULL DEFAULT 'calibration'
    CHECK (kind IN ('calibration', 'reference_change'));
UPDATE records SET kind = 'reference_change'
    WHERE points = 0 AND (SELECT substr(bytes, 2, 1) = x'01' FROM contents WHERE record = id);
