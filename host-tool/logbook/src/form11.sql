-- The nominal sensitivity of a sensor is one to the motion that its `unit` names, in V, C or A per SI unit of that;
-- until here it was V/(m/s2), which the units there were said. What was entered keeps its values.
ALTER TABLE sensors RENAME COLUMN sensitivity_v_per_ms2 TO sensitivity;
-- A record may measure again what had no result in that of a certificate.
DROP TRIGGER joined_stay;
DROP TRIGGER joined_are_kept;
ALTER TABLE joined RENAME TO joined_before;
CREATE TABLE joined (
    certificate TEXT NOT NULL,
    role TEXT NOT NULL CHECK (role IN ('as_found', 'remounted', 'retried')),
    record_sha256 BLOB NOT NULL,
    PRIMARY KEY (certificate, role, record_sha256)
) STRICT, WITHOUT ROWID;
INSERT INTO joined SELECT certificate, role, record_sha256 FROM joined_before;
DROP TABLE joined_before;
CREATE TRIGGER joined_stay BEFORE UPDATE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not changed'); END;
CREATE TRIGGER joined_are_kept BEFORE DELETE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not removed'); END;
