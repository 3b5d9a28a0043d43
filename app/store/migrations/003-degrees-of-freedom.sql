-- unidentifiable: combinations of parameters that no reading sees, as JSON; NULL in rows of earlier versions.
-- Coverage factors, the part of the touches in u of a value, and identifications whose nominal arm the readings could
-- not evaluate. SQLite cannot take NOT NULL from a column: the table is made anew, and the one that refers to it.

CREATE TABLE identifications_2 (
  recording TEXT NOT NULL PRIMARY KEY REFERENCES recordings (recording) ON DELETE CASCADE,
  rank INTEGER NOT NULL,
  noise_mm DOUBLE PRECISION NOT NULL,
  noise_is_given INTEGER NOT NULL,
  chi_squared DOUBLE PRECISION NOT NULL,
  degrees_of_freedom INTEGER NOT NULL,
  enlargement DOUBLE PRECISION NOT NULL,
  rms_before_mm DOUBLE PRECISION,
  maximum_before_mm DOUBLE PRECISION,
  rms_after_mm DOUBLE PRECISION NOT NULL,
  maximum_after_mm DOUBLE PRECISION NOT NULL,
  rms_left_out_mm DOUBLE PRECISION,
  outliers INTEGER NOT NULL,
  covariance TEXT NOT NULL,
  arm_file TEXT,
  unidentifiable TEXT
);
INSERT INTO identifications_2 SELECT recording, rank, noise_mm, noise_is_given, chi_squared, degrees_of_freedom,
    enlargement, rms_before_mm, maximum_before_mm, rms_after_mm, maximum_after_mm, rms_left_out_mm, outliers, covariance,
    arm_file, NULL
  FROM identifications;

-- coverage_factor: of u, for 95 %; NULL in rows of earlier versions. degrees_of_freedom: effective ones of u; NULL: so
-- many that they do not matter, or not known.
CREATE TABLE parameters_2 (
  recording TEXT NOT NULL REFERENCES identifications_2 (recording) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  state TEXT NOT NULL,
  nominal DOUBLE PRECISION NOT NULL,
  identified DOUBLE PRECISION NOT NULL,
  u DOUBLE PRECISION,
  degrees_of_freedom DOUBLE PRECISION,
  coverage_factor DOUBLE PRECISION,
  PRIMARY KEY (recording, position)
);
INSERT INTO parameters_2 SELECT recording, position, name, unit, state, nominal, identified, u, NULL, NULL
  FROM parameters;

DROP TABLE parameters;
DROP TABLE identifications;
ALTER TABLE identifications_2 RENAME TO identifications;
ALTER TABLE parameters_2 RENAME TO parameters;

ALTER TABLE verification_values ADD COLUMN u_points_mm DOUBLE PRECISION NOT NULL DEFAULT 0;
ALTER TABLE verification_values ADD COLUMN degrees_of_freedom DOUBLE PRECISION;
ALTER TABLE verification_values ADD COLUMN coverage_factor DOUBLE PRECISION;
