#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "core/error.h"

namespace artcal {

/// The pages of a batch's recordings, in a folder beside the index: of "night.html" in "night-reports". A page is named
/// after its recording's folder (or file) and by its content, as a result is: "arm-17-2f60c1a94be07d35.html". What file
/// names may hold does not get into it, two recordings never share one unless they are the same, and a page that is
/// there is that of the result.
class ReportPages {
 public:
  enum class Kind {
    Shared,         ///< the pages take their plots from one file in the folder
    SelfContained,  ///< each carries them, 1.8 MB, and may be sent alone
  };
  ReportPages(const std::string& index, Kind kind);

  /// Makes the folder and what the pages share. What goes wrong is the error of every page.
  void begin();
  /// Whole or not at all. REQUIRES: results of one recording, not empty.
  [[nodiscard]] Expected<void> write(const std::string& path, const std::string& recording,
                                     const std::vector<ReportedResult>& results) const;
  [[nodiscard]] bool has(const std::string& path, const std::string& recording) const;
  /// As seen from the index.
  [[nodiscard]] std::string link(const std::string& path, const std::string& recording) const;
  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  [[nodiscard]] std::string file(const std::string& path, const std::string& recording) const;

  std::string folder_;
  Kind kind_;
  std::optional<Error> cannot_begin_;
};

}  // namespace artcal
