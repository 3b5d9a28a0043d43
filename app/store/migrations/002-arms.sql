-- The identified arm as a file states it (docs/files.md, arm.toml). NULL in results that earlier versions wrote.
ALTER TABLE identifications ADD COLUMN arm_file TEXT;
