#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace artcal {

/// What a page draws and does beside its text.
enum class Scripts {
  Plots,        ///< Plotly and the figures of a report
  SharedPlots,  ///< the same, from shared_scripts() in a file beside the page
  Sorting,      ///< tables that are sorted by a click on a column's head
};

/// One page. Its policy (Content-Security-Policy) lets the browser run the scripts that this program put in, known by
/// their hashes, and nothing else, and load nothing from anywhere. With SharedPlots it lets it load scripts from where
/// the page itself lies too: without them the page says what is missing and has everything but its pictures.
struct Page {
  std::string title;            ///< text
  std::string body;             ///< markup, made with app/report/html.h
  nlohmann::ordered_json data;  ///< for the scripts
  Scripts scripts = Scripts::Plots;
  std::string running = {};  ///< text at the foot of every page of paper, such as the arm's name
};

std::string page_html(const Page& page);

/// What pages with SharedPlots need beside them. The name tells its content.
struct SharedScripts {
  std::string name;
  std::string text;
};
const SharedScripts& shared_scripts();

}  // namespace artcal
