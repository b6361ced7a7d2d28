-- Signed files that were given out of a certificate: two signatures of the same thing are two files. By the sum
-- of the file, with the certificate it is of, and the key's certificate.
CREATE TABLE signed_files (
    sha256 BLOB PRIMARY KEY,
    certificate TEXT NOT NULL,
    format TEXT NOT NULL,
    signed_by TEXT NOT NULL,
    signer_sha256 BLOB NOT NULL,
    entered_s INTEGER NOT NULL
) STRICT;
CREATE TRIGGER signed_files_stay BEFORE UPDATE ON signed_files
BEGIN SELECT RAISE(ABORT, 'a signed file is not changed'); END;
CREATE TRIGGER signed_files_are_kept BEFORE DELETE ON signed_files
BEGIN SELECT RAISE(ABORT, 'a signed file is not removed'); END;
-- Which certificate replaces which, and why (ISO/IEC 17025, 7.8.8); each is replaced at most once.
CREATE TABLE amendments (
    certificate TEXT PRIMARY KEY,
    replaces TEXT NOT NULL UNIQUE,
    reason TEXT NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TRIGGER amendments_stay BEFORE UPDATE ON amendments
BEGIN SELECT RAISE(ABORT, 'an amendment is not changed'); END;
CREATE TRIGGER amendments_are_kept BEFORE DELETE ON amendments
BEGIN SELECT RAISE(ABORT, 'an amendment is not removed'); END;
-- Records that a certificate is made of beside its own: one as found, those of other mountings.
CREATE TABLE joined (
    certificate TEXT NOT NULL,
    role TEXT NOT NULL CHECK (role IN ('as_found', 'remounted')),
    record_sha256 BLOB NOT NULL,
    PRIMARY KEY (certificate, role, record_sha256)
) STRICT, WITHOUT ROWID;
CREATE TRIGGER joined_stay BEFORE UPDATE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not changed'); END;
CREATE TRIGGER joined_are_kept BEFORE DELETE ON joined
BEGIN SELECT RAISE(ABORT, 'what a certificate is made of is not removed'); END;
