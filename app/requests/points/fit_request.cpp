#include "app/requests/points/fit_request.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::array shapes{std::pair{"sphere", Shape::Sphere},     std::pair{"plane", Shape::Plane},
                            std::pair{"line", Shape::Line},         std::pair{"circle", Shape::Circle},
                            std::pair{"cylinder", Shape::Cylinder}, std::pair{"cone", Shape::Cone}};
constexpr std::array criteria{std::pair{"least-squares", Criterion::LeastSquares},
                              std::pair{"minimum-zone", Criterion::MinimumZone},
                              std::pair{"minimum-circumscribed", Criterion::MinimumCircumscribed},
                              std::pair{"maximum-inscribed", Criterion::MaximumInscribed}};

template <typename Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) {
    names.emplace_back(entry.first);
  }
  return names;
}

template <typename Table, typename Value>
std::string_view find_name(const Table& table, Value value) {
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.second == value; })->first;
}

template <typename Table>
auto find_value(const Table& table, const std::string& name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.first == name; });
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

// A length above zero, nothing for an empty text.
Expected<std::optional<double>> length_of(const std::string& text, std::string_view option) {
  if (text.empty()) {
    return std::nullopt;
  }
  const auto length = length_quantity(text);
  if (!length || *length <= 0.0) {
    return wrong_usage(fmt::format("{}: found {}, expected a length above zero with its unit, such as \"25.4 mm\"{}",
                                   option, in_quotes(text), decimal_comma_question(text)));
  }
  return length;
}

Expected<void> take_lengths(const FitWords& words, FitOptions& options) {
  const auto diameter = length_of(words.diameter, "--diameter");
  const auto tip = length_of(words.tip_diameter, "--tip-diameter");
  const auto noise = length_of(words.noise, "--noise");
  for (const auto* length : {&diameter, &tip, &noise}) {
    if (!*length) {
      return tl::unexpected(length->error());
    }
  }
  if (*diameter) {
    options.fixed_radius = **diameter / 2.0;
  }
  options.tip_radius = tip->value_or(0.0) / 2.0;
  options.noise = *noise;
  return {};
}

Expected<void> take_vector(const char* option, const std::vector<double>& numbers,
                           std::optional<Eigen::Vector3d>& vector) {
  if (numbers.empty()) {
    return {};
  }
  if (numbers.size() != 3) {
    return wrong_usage(fmt::format("{}: found {} numbers, expected three, such as 0,0,1", option, numbers.size()));
  }
  vector = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  return {};
}

std::string_view shape_name(Shape shape) { return find_name(shapes, shape); }

// Options that would be passed over in silence, and then be believed to have had an effect.
Expected<void> check_pairing(const FitWords& words, const FitRequest& request) {
  const Shape shape = request.shape;
  if (request.options.circle_normal && shape != Shape::Circle) {
    return wrong_usage(fmt::format("--normal is for a circle, not for a {}", shape_name(shape)));
  }
  if (request.options.circle_normal && words.spatial) {
    return wrong_usage("--normal states the plane of a circle, --spatial looks for it; leave one of them out");
  }
  if (request.options.circle_normal && words.robust) {
    return wrong_usage(
        "--normal is not available together with --robust: outliers are looked for in space; leave one out");
  }
  if (words.inside && (shape == Shape::Plane || shape == Shape::Line)) {
    return wrong_usage(fmt::format("--inside is for what is round; a {} has no inside{}", shape_name(shape),
                                   shape == Shape::Plane ? ", state --towards" : ""));
  }
  if (request.options.towards && shape == Shape::Cone) {
    return wrong_usage("--towards has no meaning for a cone: its direction points from the apex into the opening");
  }
  if (request.options.towards && shape == Shape::Sphere && !request.options.fixed_radius) {
    return wrong_usage("--towards has a meaning for a sphere only together with its --diameter");
  }
  if (request.options.noise && request.options.criterion != Criterion::LeastSquares) {
    return wrong_usage(fmt::format("--noise belongs to least squares: {} gives no uncertainty", words.criterion));
  }
  return {};
}

}  // namespace

std::string_view name_of(Shape shape) { return shape_name(shape); }
std::string_view name_of(Criterion criterion) { return find_name(criteria, criterion); }
std::vector<std::string> shape_names() { return names_of(shapes); }
std::vector<std::string> criterion_names() { return names_of(criteria); }

Expected<FitRequest> parse(const FitWords& words) {
  FitRequest request;
  const auto shape = find_value(shapes, words.shape);
  const auto criterion = find_value(criteria, words.criterion);
  const auto unit = length_unit(words.unit);
  if (!shape || !criterion) {
    return wrong_usage(fmt::format("{} is not known", in_quotes(shape ? words.criterion : words.shape)));
  }
  if (!unit) {
    return wrong_usage(fmt::format(
        "--unit: found {}, expected the unit of the coordinates in the file: mm, um, m or in", in_quotes(words.unit)));
  }
  request.shape = *shape;
  request.unit = words.unit;
  request.unit_factor = *unit;
  request.robust = words.robust;
  request.options.criterion = *criterion;
  if (auto taken = take_lengths(words, request.options); !taken) {
    return tl::unexpected(taken.error());
  }
  if (words.inside && words.tip_diameter.empty()) {
    return wrong_usage("--inside says on which side a tip touched; state its --tip-diameter");
  }
  if (words.spatial && request.shape != Shape::Circle) {
    return wrong_usage("--spatial is for a circle");
  }
  request.options.side = words.inside ? Side::Inside : Side::Outside;
  request.options.circle = words.spatial ? CircleConvention::Spatial : CircleConvention::Projected;
  for (const auto& [option, numbers, vector] :
       {std::tuple("--towards", &words.towards, &request.options.towards),
        std::tuple("--normal", &words.normal, &request.options.circle_normal)}) {
    if (auto taken = take_vector(option, *numbers, *vector); !taken) {
      return tl::unexpected(taken.error());
    }
  }
  return check_pairing(words, request).map([&] { return request; });
}

}  // namespace artcal
