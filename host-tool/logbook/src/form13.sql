-- A point has a state, in the word of every output: a verdict is said of a gap only.
ALTER TABLE points RENAME COLUMN verdict TO state;
