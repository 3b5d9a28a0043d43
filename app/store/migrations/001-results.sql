-- Results of many recordings. Lengths in mm, angles in rad, temperatures in degC. docs/store.md says what each is for.

-- An arm, by the name its file states.
CREATE TABLE arms (
  arm TEXT NOT NULL PRIMARY KEY
);

CREATE TABLE artefacts (
  artefact TEXT NOT NULL PRIMARY KEY,
  name TEXT NOT NULL,
  type TEXT NOT NULL
);

-- What is not stated is NULL; an artefact without a certificate has one row of NULLs.
CREATE TABLE certificates (
  certificate TEXT NOT NULL PRIMARY KEY,
  artefact TEXT NOT NULL REFERENCES artefacts (artefact),
  number TEXT,
  laboratory TEXT,
  issued_on TEXT,
  valid_until TEXT
);

-- One row for each content that was computed: a recording with all its inputs, a program's version, its options.
CREATE TABLE recordings (
  recording TEXT NOT NULL PRIMARY KEY,
  program TEXT NOT NULL,
  options TEXT NOT NULL,
  name TEXT NOT NULL,
  measured_on TEXT,
  arm TEXT NOT NULL REFERENCES arms (arm),
  readings INTEGER NOT NULL,
  exit_code INTEGER NOT NULL,
  error TEXT
);
CREATE INDEX recordings_by_arm ON recordings (arm, measured_on);

CREATE TABLE inputs (
  recording TEXT NOT NULL REFERENCES recordings (recording) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  path TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  PRIMARY KEY (recording, position)
);
CREATE INDEX inputs_by_content ON inputs (sha256);

CREATE TABLE used_certificates (
  recording TEXT NOT NULL REFERENCES recordings (recording) ON DELETE CASCADE,
  certificate TEXT NOT NULL REFERENCES certificates (certificate),
  PRIMARY KEY (recording, certificate)
);
CREATE INDEX used_certificates_by_certificate ON used_certificates (certificate);

-- covariance: rows of the identified parameters' covariance up to the diagonal, as JSON, in the order of parameters.
CREATE TABLE identifications (
  recording TEXT NOT NULL PRIMARY KEY REFERENCES recordings (recording) ON DELETE CASCADE,
  rank INTEGER NOT NULL,
  noise_mm DOUBLE PRECISION NOT NULL,
  noise_is_given INTEGER NOT NULL,
  chi_squared DOUBLE PRECISION NOT NULL,
  degrees_of_freedom INTEGER NOT NULL,
  enlargement DOUBLE PRECISION NOT NULL,
  rms_before_mm DOUBLE PRECISION NOT NULL,
  maximum_before_mm DOUBLE PRECISION NOT NULL,
  rms_after_mm DOUBLE PRECISION NOT NULL,
  maximum_after_mm DOUBLE PRECISION NOT NULL,
  rms_left_out_mm DOUBLE PRECISION,
  outliers INTEGER NOT NULL,
  covariance TEXT NOT NULL
);

CREATE TABLE parameters (
  recording TEXT NOT NULL REFERENCES identifications (recording) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  state TEXT NOT NULL,
  nominal DOUBLE PRECISION NOT NULL,
  identified DOUBLE PRECISION NOT NULL,
  u DOUBLE PRECISION,
  PRIMARY KEY (recording, position)
);

CREATE TABLE verifications (
  recording TEXT NOT NULL PRIMARY KEY REFERENCES recordings (recording) ON DELETE CASCADE,
  standard TEXT NOT NULL,
  specification TEXT,
  decision_rule TEXT NOT NULL,
  conclusion TEXT NOT NULL
);

CREATE TABLE verification_values (
  recording TEXT NOT NULL REFERENCES verifications (recording) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  quantity TEXT NOT NULL,
  artefact TEXT NOT NULL,
  placement TEXT NOT NULL,
  feature TEXT NOT NULL,
  other_feature TEXT,
  repetition TEXT NOT NULL,
  certified_mm DOUBLE PRECISION,
  measured_mm DOUBLE PRECISION NOT NULL,
  value_mm DOUBLE PRECISION NOT NULL,
  temperature_c DOUBLE PRECISION,
  limit_mm DOUBLE PRECISION,
  u_mm DOUBLE PRECISION NOT NULL,
  u_calibration_mm DOUBLE PRECISION NOT NULL,
  u_expansion_mm DOUBLE PRECISION NOT NULL,
  u_temperature_mm DOUBLE PRECISION NOT NULL,
  u_alignment_mm DOUBLE PRECISION NOT NULL,
  u_fixture_mm DOUBLE PRECISION NOT NULL,
  u_form_mm DOUBLE PRECISION NOT NULL,
  verdict TEXT NOT NULL,
  set_aside INTEGER NOT NULL,
  PRIMARY KEY (recording, position)
);

-- Warnings, and what is missing for a complete verification.
CREATE TABLE remarks (
  recording TEXT NOT NULL REFERENCES recordings (recording) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  kind TEXT NOT NULL,
  remark TEXT NOT NULL,
  PRIMARY KEY (recording, position)
);

-- Every recording file that was asked for, and what became of it. Without a recording it could not be read.
CREATE TABLE files (
  path TEXT NOT NULL PRIMARY KEY,
  recording TEXT REFERENCES recordings (recording),
  exit_code INTEGER NOT NULL,
  error TEXT
);
CREATE INDEX files_by_recording ON files (recording);

-- When a result came into this store (UTC); nothing else in a store depends on when it was made.
CREATE TABLE stored (
  recording TEXT NOT NULL PRIMARY KEY REFERENCES recordings (recording) ON DELETE CASCADE,
  stored_at TEXT NOT NULL
);

-- The results that stand: those of the files as they are now.
CREATE VIEW current_recordings AS
  SELECT * FROM recordings WHERE recording IN (SELECT recording FROM files);
