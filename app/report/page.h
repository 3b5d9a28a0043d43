#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace artcal {

/// What a page draws and does beside its text.
enum class Scripts {
  Plots,    ///< Plotly and the figures of a report
  Sorting,  ///< tables that are sorted by a click on a column's head
};

/// One page that needs nothing beside itself. Its policy (Content-Security-Policy) lets the browser run the scripts
/// that this program put in, known by their hashes, and nothing else, and load nothing from anywhere.
struct Page {
  std::string title;            ///< text
  std::string body;             ///< markup, made with app/report/html.h
  nlohmann::ordered_json data;  ///< for the scripts
  Scripts scripts = Scripts::Plots;
};

std::string page_html(const Page& page);

}  // namespace artcal
