#pragma once

#include <string_view>

/// The files of app/report/web and Plotly, as they were when the program was built: they are part of it.
namespace artcal::web_files {

std::string_view plotly();
std::string_view plotly_licence();  ///< goes wherever Plotly goes
std::string_view figures();         ///< draws every figure of a report from the page's data
std::string_view missing();         ///< says what is missing where a page cannot draw its figures
std::string_view sorting();         ///< sorts tables
std::string_view style();           ///< for the screen and for paper

}  // namespace artcal::web_files
