-- A certificate may be by substitution: the record of the standard is part of what it is made of.
DROP TRIGGER joined_stay;
DROP TRIGGER joined_are_kept;
ALTER TABLE joined RENAME TO joined_before;
CREATE TABLE joined (
    certificate TEXT NOT NULL,
    role TEXT NOT NULL CHECK (role IN ('as_found', 'remounted', 'retried', 'standard')),
    record_sha256 BLOB NOT NULL,
    PRIMARY KEY (certificate, role, record_sha256)
) STRICT, WITHOUT ROWID;
INSERT INTO joined SELECT certificate, role, record_sha256 FROM joined_before;
DROP TABLE joined_before;
CREATE TRIGGER joined_stay BEFORE UPDATE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not changed'); END;
CREATE TRIGGER joined_are_kept BEFORE DELETE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not removed'); END;
