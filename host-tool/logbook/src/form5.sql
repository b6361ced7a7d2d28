-- Public keys of instruments (Ed25519), and the first record each signed.
CREATE TABLE keys (
    instrument TEXT PRIMARY KEY,
    public BLOB NOT NULL,
    since INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
