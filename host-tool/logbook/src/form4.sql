-- Everything that was entered by a person or given out, in its order: sensors as they were stated, records
-- and certificates. `sum` is the SHA-256 of the row, none for one that was removed; `chain` that of the entry
-- and of the chain before it (see journal.rs).
CREATE TABLE journal (
    number INTEGER PRIMARY KEY,
    subject TEXT NOT NULL,
    name TEXT NOT NULL,
    sum BLOB,
    chain BLOB NOT NULL
) STRICT;
CREATE TRIGGER journal_stays BEFORE UPDATE ON journal
BEGIN SELECT RAISE(ABORT, 'an entry of the journal is not changed'); END;
CREATE TRIGGER journal_is_kept BEFORE DELETE ON journal
BEGIN SELECT RAISE(ABORT, 'an entry of the journal is not removed'); END;
