#include "app/report/web_files.h"

// Laid into the program by web_files.S.
extern "C" {
extern const char artcal_plotly_begin, artcal_plotly_end;
extern const char artcal_plotly_licence_begin, artcal_plotly_licence_end;
extern const char artcal_figures_begin, artcal_figures_end;
extern const char artcal_missing_begin, artcal_missing_end;
extern const char artcal_sorting_begin, artcal_sorting_end;
extern const char artcal_style_begin, artcal_style_end;
}

namespace artcal::web_files {
namespace {

std::string_view between(const char& begin, const char& end) {
  return {&begin, static_cast<std::size_t>(&end - &begin)};
}

}  // namespace

std::string_view plotly() { return between(artcal_plotly_begin, artcal_plotly_end); }
std::string_view plotly_licence() { return between(artcal_plotly_licence_begin, artcal_plotly_licence_end); }
std::string_view figures() { return between(artcal_figures_begin, artcal_figures_end); }
std::string_view missing() { return between(artcal_missing_begin, artcal_missing_end); }
std::string_view sorting() { return between(artcal_sorting_begin, artcal_sorting_end); }
std::string_view style() { return between(artcal_style_begin, artcal_style_end); }

}  // namespace artcal::web_files
