#include <algorithm>

#include <fmt/format.h>

#include "app/plan_result.h"
#include "app/report/html.h"

namespace artcal {
namespace {

constexpr double panel = 420.0;  // points of the picture
constexpr double margin = 40.0;

/// One view of the volume: across is the axis to the right, up the one upwards.
struct View {
  const char* title;
  int across, up;
  double left;   ///< of the panel
  double scale;  ///< points per mm
  Eigen::Vector3d middle;

  [[nodiscard]] double x(const Eigen::Vector3d& at) const {
    return left + 0.5 * panel + scale * (at[across] - middle[across]);
  }
  [[nodiscard]] double y(const Eigen::Vector3d& at) const {
    return margin + 0.5 * panel - scale * (at[up] - middle[up]);
  }
};

std::string frame_of(const View& view, double reach_of_arm) {
  const Eigen::Vector3d& middle = view.middle;
  return fmt::format(
      "<text x=\"{:.0f}\" y=\"24\" font-weight=\"bold\">{}</text>\n"
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>\n"
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#f4f7fb\" stroke=\"#789\" stroke-dasharray=\"4 3\"/>\n"
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#333\"/>\n",
      view.left, view.title, view.left, margin, panel, panel, view.x(middle), view.y(middle), view.scale * reach_of_arm,
      view.x(Eigen::Vector3d::Zero()), view.y(Eigen::Vector3d::Zero()));
}

std::string line_of(const View& view, const StandingEnds& ends, const char* style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", view.x(ends.first_in_base),
                     view.y(ends.first_in_base), view.x(ends.last_in_base), view.y(ends.last_in_base), style);
}

std::string placements_of(const View& view, const PlanResult& result) {
  std::string text;
  for (int i = 0; i < static_cast<int>(result.possible.placements.size()); ++i) {
    text += line_of(view, ends_of(result.possible, i), "stroke=\"#bbb\" stroke-width=\"1\"");
  }
  for (const ChosenPlacement& chosen : result.planning.chosen) {
    const StandingEnds ends = ends_of(result.possible, chosen.candidate);
    text += line_of(view, ends, "stroke=\"#0057b7\" stroke-width=\"4\" stroke-linecap=\"round\"");
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", view.x(ends.last_in_base) + 6.0,
                        view.y(ends.last_in_base) - 4.0,
                        html::text(result.possible.placements[static_cast<std::size_t>(chosen.candidate)].name));
  }
  return text;
}

}  // namespace

std::string to_picture(const PlanResult& result) {
  const double reach_of_arm = reach(result.plan.nominal);
  const Eigen::Vector3d shoulder(0.0, 0.0, result.plan.nominal.joints.front().d);
  const double scale = 0.48 * panel / reach_of_arm;
  const View above{"from above: x to the right, y up", 0, 1, margin, scale, shoulder};
  const View aside{"from the side: x to the right, z up", 0, 2, 2.0 * margin + panel, scale, shoulder};
  const double width = 3.0 * margin + 2.0 * panel;
  const double height = panel + 2.0 * margin + 24.0;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\" role=\"img\">\n"
      "<title>Where to put the artefact</title>\n<desc>{} of {} possible placements in the reach of the arm, seen from "
      "above and from the side; the chosen ones are thick and numbered.</desc>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height, width, height, result.planning.chosen.size(), result.possible.placements.size());
  for (const View& view : {above, aside}) {
    text += frame_of(view, reach_of_arm) + placements_of(view, result);
  }
  return text +
         fmt::format(
             "<text x=\"{:.0f}\" y=\"{:.0f}\">thick: chosen; thin: possible; dashed: reach of the arm, {:.0f} mm; "
             "dot: origin of the base</text>\n</svg>\n",
             margin, panel + margin + 28.0, reach_of_arm);
}

}  // namespace artcal
