-- The terms of the glossary: the factor on standard uncertainties, and the states of parameters.
ALTER TABLE identifications RENAME COLUMN enlargement TO scale_factor;
UPDATE parameters SET state = 'fixed' WHERE state = 'held';
UPDATE parameters SET state = 'unidentifiable' WHERE state = 'lost';
