#include "app/store/shape.h"

namespace artcal {
namespace {

constexpr auto as_text = ColumnKind::Text;
constexpr auto as_whole = ColumnKind::Whole;
constexpr auto as_real = ColumnKind::Real;

std::array<TableShape, store_table_count> make_shapes() {
  return {{
      {"arms", {{"arm", as_text}}, 1},
      {"artefacts", {{"artefact", as_text}, {"name", as_text}, {"type", as_text}}, 1},
      {"certificates",
       {{"certificate", as_text},
        {"artefact", as_text},
        {"number", as_text},
        {"laboratory", as_text},
        {"issued_on", as_text},
        {"valid_until", as_text}},
       1},
      {"recordings",
       {{"recording", as_text},
        {"program", as_text},
        {"options", as_text},
        {"name", as_text},
        {"measured_on", as_text},
        {"arm", as_text},
        {"readings", as_whole},
        {"exit_code", as_whole},
        {"error", as_text}},
       1},
      {"inputs", {{"recording", as_text}, {"position", as_whole}, {"path", as_text}, {"sha256", as_text}}, 2},
      {"used_certificates", {{"recording", as_text}, {"certificate", as_text}}, 2},
      {"identifications",
       {{"recording", as_text},
        {"rank", as_whole},
        {"noise_mm", as_real},
        {"noise_is_given", as_whole},
        {"chi_squared", as_real},
        {"degrees_of_freedom", as_whole},
        {"scale_factor", as_real},
        {"rms_before_mm", as_real},
        {"maximum_before_mm", as_real},
        {"rms_after_mm", as_real},
        {"maximum_after_mm", as_real},
        {"rms_left_out_mm", as_real},
        {"outliers", as_whole},
        {"covariance", as_text},
        {"arm_file", as_text},
        {"unidentifiable", as_text}},
       1},
      {"parameters",
       {{"recording", as_text},
        {"position", as_whole},
        {"name", as_text},
        {"unit", as_text},
        {"state", as_text},
        {"nominal", as_real},
        {"identified", as_real},
        {"u", as_real},
        {"degrees_of_freedom", as_real},
        {"coverage_factor", as_real}},
       2},
      {"verifications",
       {{"recording", as_text},
        {"standard", as_text},
        {"specification", as_text},
        {"decision_rule", as_text},
        {"conclusion", as_text}},
       1},
      {"verification_values",
       {{"recording", as_text},        {"position", as_whole},
        {"quantity", as_text},         {"artefact", as_text},
        {"placement", as_text},        {"feature", as_text},
        {"other_feature", as_text},    {"repetition", as_text},
        {"certified_mm", as_real},     {"measured_mm", as_real},
        {"value_mm", as_real},         {"temperature_c", as_real},
        {"limit_mm", as_real},         {"u_mm", as_real},
        {"u_calibration_mm", as_real}, {"u_expansion_mm", as_real},
        {"u_temperature_mm", as_real}, {"u_alignment_mm", as_real},
        {"u_fixture_mm", as_real},     {"u_form_mm", as_real},
        {"verdict", as_text},          {"set_aside", as_whole},
        {"u_points_mm", as_real},      {"degrees_of_freedom", as_real},
        {"coverage_factor", as_real}},
       2},
      {"remarks", {{"recording", as_text}, {"position", as_whole}, {"kind", as_text}, {"remark", as_text}}, 2},
      {"files", {{"path", as_text}, {"recording", as_text}, {"exit_code", as_whole}, {"error", as_text}}, 1},
      {"stored", {{"recording", as_text}, {"stored_at", as_text}}, 1},
  }};
}

}  // namespace

const TableShape& shape_of(StoreTable table) {
  static const auto shapes = make_shapes();
  return shapes[static_cast<std::size_t>(table)];
}

std::string text_or_empty(const StoreValue& value) {
  const auto* as_text = std::get_if<std::string>(&value);
  return as_text != nullptr ? *as_text : std::string();
}

}  // namespace artcal
