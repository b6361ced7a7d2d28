-- The mounted resonance by the data sheet of a sensor, whole Hz, which have one text. The journal's sum of a sensor that
-- has none is what it was.
ALTER TABLE sensors ADD COLUMN resonance_hz INTEGER;
