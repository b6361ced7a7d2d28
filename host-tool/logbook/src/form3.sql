-- The tolerance of a sensor, as text (see decision::Tolerance), and the unit its sensitivity is
-- specified in. The state of a point has the word every output uses.
ALTER TABLE sensors ADD COLUMN tolerance TEXT;
ALTER TABLE sensors ADD COLUMN unit TEXT;
UPDATE points SET verdict = 'valid' WHERE verdict = 'pass';
