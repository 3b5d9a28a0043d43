#include "app/import/import_request.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "acquisition/import/column_roles.h"
#include "acquisition/import/dmis_file.h"
#include "acquisition/import/pcdmis_report.h"
#include "acquisition/import/qif_file.h"
#include "acquisition/point_cloud/cloud_formats.h"
#include "acquisition/recording/recording_file.h"
#include "app/import/feature_check.h"
#include "app/import/import_preview.h"
#include "app/output/output.h"
#include "app/requests/path_from_folder.h"
#include "core/files/file_bytes.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_import = std::size_t{64} << 20;

const std::map<std::string, Delimiter>& delimiters() {
  static const std::map<std::string, Delimiter> known{{"semicolon", Delimiter::Semicolon},
                                                      {"tab", Delimiter::Tab},
                                                      {"comma", Delimiter::Comma},
                                                      {"blank", Delimiter::Blanks}};
  return known;
}

bool any_column(const ImportedReadings& readings, bool (*is_such)(const std::string&)) {
  return std::any_of(readings.columns.begin(), readings.columns.end(), is_such);
}

// Which of the formats of --format a file is.
std::string format_of(const ImportRequest& request, const TextFile& file) {
  return request.format != "auto" ? request.format
         : is_qif_file(file)      ? "qif"
         : is_pcdmis_report(file) ? "pc-dmis"
         : is_dmis_file(file)     ? "dmis"
                                  : "text";
}

// Points of a scan need no recording.
Expected<void> check_no_cloud(const std::string& path) {
  const auto file = read_file_bytes(path, largest_import);
  if (!file) {
    return {};  // read_text_file() says why
  }
  std::string_view bytes = file->bytes;
  bytes.remove_prefix(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  const std::string_view cloud = cloud_format_name(bytes);
  return cloud.empty()
             ? Expected<void>{}
             : bad_input(fmt::format("the file is a point cloud ({}), which is read as it is: by artcal fit, by artcal "
                                     "segment, or named under [[scan]] in a recording",
                                     cloud),
                         path);
}

Expected<ImportedReadings> read(const ImportRequest& request) {
  if (auto none = request.format == "auto" ? check_no_cloud(request.input) : Expected<void>{}; !none) {
    return tl::unexpected(none.error());
  }
  const auto file = read_text_file(request.input, largest_import);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const std::string format = format_of(request, *file);
  if (format != "text" && !(request.columns.empty() && request.separator.empty() && request.skip == 0)) {
    return wrong_usage(fmt::format(
        "--columns, --separator and --skip are for tables, and this is {}; --format text takes it as a table "
        "all the same",
        format == "qif"    ? "QIF"
        : format == "dmis" ? "DMIS"
                           : "a PC-DMIS report"));
  }
  if (format != "dmis" && request.points_are_measured) {
    return wrong_usage("--measured-points says what the PTMEAS of a DMIS file are, and this is none");
  }
  if (format == "qif") {
    return import_qif(*file);
  }
  if (format == "dmis") {
    return import_dmis(*file, request.points_are_measured);
  }
  if (format == "pc-dmis") {
    return import_pcdmis_report(*file);
  }
  TextImport options{request.columns, std::nullopt, request.skip};
  if (!request.separator.empty()) {
    options.delimiter = delimiters().at(request.separator);
  }
  return import_text(*file, options);
}

// The radius of the tip, mm, that the file states, or the person; the same where both do. Nothing where neither does.
Expected<std::optional<double>> probe_radius_of(const ImportRequest& request, const ImportedReadings& readings,
                                                const std::string& unit) {
  const auto stated = length_quantity(request.probe_radius);
  if (!request.probe_radius.empty() && !stated) {
    return wrong_usage(fmt::format("--probe-radius is {}, expected a length with its unit, such as \"3 mm\"",
                                   in_quotes(request.probe_radius)));
  }
  if (readings.probe_radius.empty() || unit.empty()) {
    return stated;
  }
  const double in_file = std::strtod(readings.probe_radius.c_str(), nullptr) * *artcal::length_unit(unit);
  constexpr double same = 1e-9;  // mm
  if (stated && std::abs(*stated - in_file) > same) {
    return wrong_usage(fmt::format("--probe-radius is {:.6g} mm, but the file states {:.6g} mm", *stated, in_file));
  }
  return in_file;
}

// The unit that the file states, or the person; the same where both do.
Expected<std::string> length_unit_of(const ImportRequest& request, const ImportedReadings& readings) {
  if (!request.unit.empty() && !readings.length_unit.empty() && request.unit != readings.length_unit) {
    return wrong_usage(
        fmt::format("--unit is {}, but the file states {}", in_quotes(request.unit), in_quotes(readings.length_unit)));
  }
  const std::string unit = request.unit.empty() ? readings.length_unit : request.unit;
  if (any_column(readings, is_length_role) && unit.empty()) {
    return wrong_usage("the file does not state the unit of its lengths; say it with --unit mm, um, m or in");
  }
  return unit;
}

Expected<std::string> recording_text(const ImportRequest& request, const ImportedReadings& readings,
                                     const std::string& length_unit) {
  const bool has_joints = any_column(readings, is_joint_role);
  if (has_joints && request.joint_unit.empty()) {
    return wrong_usage("the file has joint angles; say their unit with --joint-unit deg, rad, mrad or arcsec");
  }
  if (has_joints && request.arm.empty()) {
    return wrong_usage("the file has joint angles; name the arm that they belong to with --arm arm.toml");
  }
  const auto radius = probe_radius_of(request, readings, length_unit);
  if (!radius) {
    return tl::unexpected(radius.error());
  }
  if (request.arm.empty() && !*radius) {
    return wrong_usage(
        "say the radius of the tip that took the coordinates, such as --probe-radius \"3 mm\" (0 mm for points of the "
        "surface or centres)");
  }
  // A recording states both units; without lengths in the table that of lengths says nothing.
  const std::string units =
      fmt::format("{}length = {}", has_joints ? fmt::format("joint = {}, ", toml_text(request.joint_unit)) : "",
                  toml_text(length_unit.empty() ? "mm" : length_unit));
  std::string text = fmt::format(
      "# Imported from {}.\nschema = \"artcal-recording/1\"\nname = {}\n{}artefacts = [{}]\nreadings = "
      "[\"readings.csv\"]\nunits = {{ {} }}\n",
      truncated(200, fs::path(request.input).filename().string()),
      toml_text(truncated(80, fs::path(request.input).stem().string())),
      request.arm.empty() ? "" : fmt::format("arm = {}\n", toml_text(path_from_folder(request.arm, request.folder))),
      toml_text(path_from_folder(request.artefact, request.folder)), units);
  if (request.arm.empty()) {
    // In the recording's unit.
    text += fmt::format("\n[[probe]]\nradius = {}\n", toml_number(**radius / *artcal::length_unit(length_unit)));
  }
  return text;
}

// The preview, and where the unit of the lengths is known a check against the features that the file reports.
Expected<std::string> preview_of(const ImportRequest& request, const ImportedReadings& readings) {
  const std::string text = import_preview(request.input, readings);
  const std::string unit = request.unit.empty() ? readings.length_unit : request.unit;
  if (unit.empty()) {
    return text;
  }
  return probe_radius_of(request, readings, unit).map([&](const std::optional<double>& radius) {
    return text + feature_check(readings, *artcal::length_unit(unit), radius.value_or(0.0));
  });
}

Expected<void> check_folder(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {"readings.csv", "recording.toml"}) {
    if (fs::exists(fs::path(folder) / name, ignored)) {
      return wrong_usage(fmt::format("{} is there already; give another folder", (fs::path(folder) / name).string()));
    }
  }
  fs::create_directories(folder, ignored);
  return fs::is_directory(folder, ignored) ? Expected<void>{} : bad_input("the folder cannot be made", folder);
}

}  // namespace

Expected<int> ImportRequest::run() const {
  if (!unit.empty() && !artcal::length_unit(unit)) {
    return wrong_usage(fmt::format("--unit is {}, expected mm, um, m or in", in_quotes(unit)));
  }
  if (!joint_unit.empty() && !angle_unit(joint_unit)) {
    return wrong_usage(fmt::format("--joint-unit is {}, expected deg, rad, mrad or arcsec", in_quotes(joint_unit)));
  }
  const auto readings = read(*this);
  if (!readings) {
    return tl::unexpected(readings.error());
  }
  const auto preview = quiet ? Expected<std::string>("") : preview_of(*this, *readings);
  if (!preview) {
    return tl::unexpected(preview.error());
  }
  if (folder.empty()) {
    fmt::print("{}Nothing was written; add -o FOLDER to keep it.\n", *preview);
    return 0;
  }
  const auto length = length_unit_of(*this, *readings);
  const auto recording =
      length && !artefact.empty() ? recording_text(*this, *readings, *length) : Expected<std::string>("");
  if (!length || !recording) {
    return tl::unexpected(length ? recording.error() : length.error());
  }
  if (auto made = check_folder(folder); !made) {
    return tl::unexpected(made.error());
  }
  const fs::path table = fs::path(folder) / "readings.csv", whole = fs::path(folder) / "recording.toml";
  if (auto done = write_file(table.string(), readings_csv(*readings)); !done) {
    return tl::unexpected(done.error());
  }
  if (artefact.empty()) {
    if (!quiet) {
      fmt::print("{}The readings are in {}{}. With --artefact FILE a recording is written that names them.\n", *preview,
                 table.string(), length->empty() ? "" : fmt::format(", lengths in {}", *length));
    }
    return 0;
  }
  if (auto done = write_file(whole.string(), *recording); !done) {
    return tl::unexpected(done.error());
  }
  const auto again = read_recording(whole);
  if (!again) {
    return tl::unexpected(again.error());
  }
  if (!quiet) {
    fmt::print("{}The recording is in {}.\n", *preview, whole.string());
  }
  return 0;
}

void ImportRequest::add_to(CLI::App& parser) {
  parser.add_option("file", input, "a text table, a PC-DMIS text report, DMIS or QIF 3")->required()->type_name("FILE");
  parser.add_option("-o,--output", folder, "folder for readings.csv and recording.toml; else a preview alone")
      ->type_name("FOLDER");
  parser.add_option("--format", format, "what the file is; auto looks into it")
      ->check(CLI::IsMember({"auto", "text", "pc-dmis", "dmis", "qif"}));
  parser
      .add_option("--columns", columns,
                  "what the columns hold, from the first on: name,x,y,z (- passes over one), or name=1,x=5,y=6,z=7")
      ->type_name("NAMES");
  parser.add_option("--separator", separator, "between columns; by default the first row decides")
      ->check(CLI::IsMember({"semicolon", "tab", "comma", "blank"}));
  parser.add_option("--skip", skip, "lines above the table")->check(CLI::Range(0, 1'000'000))->type_name("N");
  parser.add_flag("--measured-points", points_are_measured,
                  "the PTMEAS of a DMIS file are measured points, not the targets of a program");
  parser.add_option("--unit", unit, "of lengths: mm, um, m or in")->type_name("UNIT");
  parser.add_option("--joint-unit", joint_unit, "of joint angles: deg, rad, mrad or arcsec")->type_name("UNIT");
  parser.add_option("--artefact", artefact, "artefact.toml that the recording names")->type_name("FILE");
  parser.add_option("--arm", arm, "arm.toml that the recording names, for joint angles")->type_name("ARM");
  parser.add_option("--probe-radius", probe_radius, "of the tip that took coordinates, such as \"3 mm\"")
      ->type_name("TEXT");
  parser.add_flag("--quiet,-q", quiet, "print nothing but errors");
  parser.footer(
      "Examples:\n  artcal import points.txt\n  artcal import points.txt --columns name,x,y,z --unit mm -o monday\n  "
      "artcal import results.qif --artefact plate.toml -o monday");
}

}  // namespace artcal
