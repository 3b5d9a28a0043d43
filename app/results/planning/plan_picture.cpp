#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/report/html.h"
#include "app/results/planning/plan_result.h"

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

// 1, 2 or 5 times a power of ten, such that an axis has some six numbers.
double step_of(double span) {
  const double power = std::pow(10.0, std::floor(std::log10(span / 6.0)));
  const double share = span / 6.0 / power;
  return power * (share > 5.0 ? 10.0 : share > 2.0 ? 5.0 : share > 1.0 ? 2.0 : 1.0);
}

// Numbers in mm along the lower and the left side, with fine lines.
std::string axes_of(const View& view) {
  const double half = 0.5 * panel / view.scale;
  const double step = step_of(2.0 * half);
  const double bottom = margin + panel;
  std::string text;
  const auto each = [&](int axis, auto draw) {
    const double low = view.middle[axis] - half, high = view.middle[axis] + half;
    for (double value = step * std::ceil(low / step); value <= high; value += step) {
      Eigen::Vector3d at = view.middle;
      at[axis] = value;
      draw(at, std::round(value / step) * step + 0.0);
    }
  };
  each(view.across, [&](const Eigen::Vector3d& at, double value) {
    text += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"#e6e9ec\"/>\n"
        "<text class=\"number\" x=\"{0:.1f}\" y=\"{3:.1f}\" font-size=\"10\" text-anchor=\"middle\">{4:.0f}</text>\n",
        view.x(at), margin, bottom, bottom + 13.0, value);
  });
  each(view.up, [&](const Eigen::Vector3d& at, double value) {
    text += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"#e6e9ec\"/>\n"
        "<text class=\"number\" x=\"{3:.1f}\" y=\"{4:.1f}\" font-size=\"10\" text-anchor=\"end\">{5:.0f}</text>\n",
        view.left, view.y(at), view.left + panel, view.left - 4.0, view.y(at) + 3.5, value);
  });
  const char* names = "xyz";
  return text + fmt::format(
                    "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"end\">{}, mm</text>\n"
                    "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\">{}, mm</text>\n",
                    view.left + panel, bottom + 26.0, names[view.across], view.left + 4.0, margin + 13.0,
                    names[view.up]);
}

// The floor and the limits of height as lines in the view from the side; tables as rectangles in both.
std::string stand_of(const View& view, const Stand& stand) {
  std::string text;
  const auto clamped = [](double value, double low, double high) { return std::clamp(value, low, high); };
  for (const Obstacle& table : stand.tables) {
    const Eigen::Vector3d low(table.x[0], table.y[0], -1e9), high(table.x[1], table.y[1], table.top);
    const double left = clamped(view.x(low), view.left, view.left + panel);
    const double right = clamped(view.x(high), view.left, view.left + panel);
    const double top = clamped(view.y(high), margin, margin + panel);
    const double bottom = clamped(view.y(low), margin, margin + panel);
    text += fmt::format(
        "<rect class=\"table\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#d9c7a8\" "
        "fill-opacity=\"0.6\" stroke=\"#8a6d3b\"/>\n",
        left, top, right - left, bottom - top);
  }
  if (view.up != 2) {
    return text;
  }
  const auto line = [&](const std::optional<double>& height, const char* name) {
    const double y = height ? view.y({0.0, 0.0, *height}) : -1.0;
    if (y >= margin && y <= margin + panel) {
      text += fmt::format(
          "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"#8a6d3b\" stroke-width=\"2\"/>\n"
          "<text x=\"{3:.1f}\" y=\"{4:.1f}\" font-size=\"11\" text-anchor=\"end\">{5}</text>\n",
          view.left, y, view.left + panel, view.left + panel - 4.0, y - 3.0, name);
    }
  };
  line(stand.floor, "floor");
  line(stand.lowest, "lowest");
  line(stand.highest, "highest");
  return text;
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
  const double height = panel + 2.0 * margin + 30.0;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\" role=\"img\">\n"
      "<title>Where to put the artefact</title>\n<desc>{} of {} possible placements in the reach of the arm, seen from "
      "above and from the side; the chosen ones are thick and numbered.</desc>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height, width, height, result.planning.chosen.size(), result.possible.placements.size());
  for (const View& view : {above, aside}) {
    text +=
        frame_of(view, reach_of_arm) + axes_of(view) + stand_of(view, result.plan.stand) + placements_of(view, result);
  }
  return text +
         fmt::format(
             "<text x=\"{:.0f}\" y=\"{:.0f}\">thick: chosen; thin: possible; dashed: reach of the arm, {:.0f} mm; "
             "dot: origin of the base</text>\n</svg>\n",
             margin, panel + margin + 46.0, reach_of_arm);
}

}  // namespace artcal
