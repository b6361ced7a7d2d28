-- Checks of the reference by reciprocity: what each found, whole, as JSON, and which is the baseline that later ones
-- are compared with.
CREATE TABLE self_checks (
    number INTEGER PRIMARY KEY,
    instrument TEXT NOT NULL,
    reference TEXT NOT NULL,
    certificate TEXT NOT NULL,
    measured_s INTEGER NOT NULL,
    baseline INTEGER NOT NULL CHECK (baseline IN (0, 1)),
    evaluation TEXT NOT NULL,
    UNIQUE (instrument, measured_s)
) STRICT;
CREATE TRIGGER self_checks_stay BEFORE UPDATE ON self_checks
BEGIN SELECT RAISE(ABORT, 'a check of the reference is not changed'); END;
CREATE TRIGGER self_checks_are_kept BEFORE DELETE ON self_checks
BEGIN SELECT RAISE(ABORT, 'a check of the reference is not removed'); END;
