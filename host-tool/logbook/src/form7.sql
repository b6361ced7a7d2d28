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
