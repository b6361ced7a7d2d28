-- The laboratory's signatures on the journal: each is over the chain up to an entry and over the signature
-- before it (see seals.rs). `statement` says why the key is another than before.
CREATE TABLE seals (
    number INTEGER PRIMARY KEY,
    entry INTEGER NOT NULL,
    signed_s INTEGER NOT NULL,
    statement TEXT NOT NULL,
    signature BLOB NOT NULL
) STRICT;
CREATE TRIGGER seals_stay BEFORE UPDATE ON seals
BEGIN SELECT RAISE(ABORT, 'a signature of the journal is not changed'); END;
CREATE TRIGGER seals_are_kept BEFORE DELETE ON seals
BEGIN SELECT RAISE(ABORT, 'a signature of the journal is not removed'); END;
