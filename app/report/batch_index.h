#pragma once

#include <optional>
#include <string>
#include <vector>

namespace artcal {

/// How one recording of a batch ended.
enum class IndexOutcome {
  Done,      ///< identified, or conformity shown
  NotShown,  ///< a verification that did not show conformity (exit code 1)
  Failed,    ///< an error: nothing came out
};

/// One line of a batch's index page. Texts are as the files have them; the page escapes them.
struct IndexRow {
  std::string recording;  ///< path or name, as a person knows it
  std::string arm;        ///< empty where it was not read
  std::string date;       ///< of the measurement, "2026-03-10"; empty: not stated
  std::string task;       ///< "identification", "iso10360-12", …
  IndexOutcome outcome = IndexOutcome::Done;
  std::string message;                     ///< the error, or the conclusion in words
  std::optional<double> rms_before;        ///< mm, of an identification
  std::optional<double> rms_after;         ///< mm
  std::optional<double> largest_of_limit;  ///< of a verification: the largest |value|/limit
  int warnings = 0;
  std::string report;  ///< link to the report, relative to the page; empty: there is none
};

/// The index page of a batch: a summary, then a table with a link to each report, which a click on a column's head
/// sorts. It needs nothing beside itself. What failed comes first, then what was not shown.
std::string index_html(const std::string& title, const std::vector<IndexRow>& rows);

}  // namespace artcal
