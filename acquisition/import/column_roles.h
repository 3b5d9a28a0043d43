#pragma once

#include <string>
#include <vector>

#include "acquisition/import/delimited_text.h"
#include "core/error.h"

namespace artcal {

/// A column of a foreign table that holds what a column of readings.csv holds.
struct ColumnRole {
  std::string role;  ///< name of a column of readings.csv: feature, x, q1 …
  std::size_t column = 0;
};

/// What the columns hold as a person states it: "name,x,y,z" from the first column on, with - for columns to be passed
/// over, or "name=2,x=5,y=6,z=Pos Z" by numbers from 1 or names of the header. `name` is the feature.
///
/// Usage: a role that is none or there twice, a column that is not there, coordinates without one of x, y, z.
Expected<std::vector<ColumnRole>> stated_roles(const std::string& columns, const std::vector<std::string>& first_row);

/// What the columns hold as a header names them: x, y, z, q1 … qn and the other columns of readings.csv, in capitals or
/// not, a unit in brackets behind them; name, label and point for the feature; joint1, j1, angle1 for q1. Other columns
/// are passed over.
///
/// Bad input: neither x, y, z nor q1 in the header, or two columns for one role. `where` is the header's place.
Expected<std::vector<ColumnRole>> roles_of_header(const std::vector<std::string>& header, const std::string& where);

/// Whether values of this role are names, not numbers.
bool is_label(const std::string& role);
/// Whether values of this role are lengths.
bool is_length_role(const std::string& role);
/// Whether it is a joint's reading.
bool is_joint_role(const std::string& role);

}  // namespace artcal
