#include "acquisition/point_cloud/mesh/obj_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "acquisition/point_cloud/cloud_builder.h"
#include "acquisition/point_cloud/text_rows.h"

namespace artcal {
namespace {

constexpr std::size_t shortest_obj_row = 8;  // "v 1 2 3\n"

// Lines that say nothing of where the vertices are.
constexpr std::array<std::string_view, 23> passed_over{
    "vt",        "vn",    "f",        "fo",       "l",      "p",      "o",     "g",
    "s",         "mg",    "mtllib",   "usemtl",   "maplib", "usemap", "lod",   "shadow_obj",
    "trace_obj", "bevel", "c_interp", "d_interp", "ctech",  "stech",  "cstech"};

// Their `v` are control points, which lie beside the surface.
constexpr std::array<std::string_view, 14> free_form{"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2",
                                                     "surf", "parm",   "trim", "hole", "scrv", "sp",   "con"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Reads the vertices from the first line to the last.
class ObjReader {
 public:
  ObjReader(const FileBytes& file, const CloudUnits& units)
      : file_(file),
        rows_(file.bytes, file.path.string(), 1, TextRows::Separator::Blanks),
        builder_(units, 3, vertex_lines(file.bytes)) {}

  Expected<ReadCloud> read() {
    bool goes_on = false;  // from the line before
    while (rows_.next()) {
      const bool is_begun = goes_on;
      goes_on = rows_.line().ends_with('\\');
      if (is_begun) {
        continue;
      }
      if (auto taken = take(goes_on); !taken) {
        return tl::unexpected(taken.error());
      }
    }
    auto warnings = rows_.check_end();
    if (!warnings) {
      return tl::unexpected(warnings.error());
    }
    return std::move(builder_).finish(file_, std::move(*warnings)).map([](PointCloud&& cloud) {
      return ReadCloud{std::move(cloud), "the vertices (v) of a Wavefront OBJ"};
    });
  }

 private:
  // Room for what the file can hold, not for what it says.
  static std::size_t vertex_lines(std::string_view bytes) {
    const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1;
    return std::min(lines, bytes.size() / shortest_obj_row + 1);
  }

  Expected<void> take(bool goes_on) {
    const std::string_view word = rows_.fields().front();
    if (word == "v") {
      return take_vertex(goes_on);
    }
    if (is_among(free_form, word)) {
      return bad_input(
          "the file has free-form curves or surfaces, whose vertices are control points and lie beside them; "
          "export it as a mesh of triangles",
          rows_.where());
    }
    if (!is_among(passed_over, word)) {
      return bad_input(
          "the line begins with no keyword of a Wavefront OBJ; expected v x y z, or f, vn, vt, g, o and such",
          rows_.where());
    }
    return {};
  }

  // v x y z, and behind it a weight, a colour or both.
  Expected<void> take_vertex(bool goes_on) {
    const std::size_t numbers = rows_.fields().size() - 1;
    if (goes_on || numbers < 3 || numbers > 8) {
      return bad_input(goes_on ? std::string("the vertex goes on in the next line, expected x, y and z in one line")
                               : fmt::format("the vertex has {} numbers, expected x, y and z", numbers),
                       rows_.where());
    }
    std::array<double, 4> values{};
    if (auto read = rows_.numbers(numbers == 4 ? with_weight_ : coordinates_, values.data()); !read) {
      return read;
    }
    if (numbers == 4 && values[3] != 1.0) {
      return bad_input(fmt::format("the vertex has the weight {:.6g}, expected 1 or none", values[3]), rows_.where());
    }
    builder_.add(values.data());
    return {};
  }

  const std::vector<std::size_t> coordinates_{1, 2, 3}, with_weight_{1, 2, 3, 4};
  const FileBytes& file_;
  TextRows rows_;
  CloudBuilder builder_;
};

}  // namespace

// Nothing but keywords until the first vertex.
bool looks_like_obj(std::string_view bytes) {
  TextRows rows(bytes, "", 1, TextRows::Separator::Blanks);
  bool goes_on = false;
  while (rows.next()) {
    const std::string_view word = rows.fields().front();
    if (word == "v" && !goes_on) {
      return rows.fields().size() >= 4 && rows.is_number_at(1) && rows.is_number_at(2) && rows.is_number_at(3);
    }
    if (!goes_on && !is_among(passed_over, word) && !is_among(free_form, word)) {
      return false;
    }
    goes_on = rows.line().ends_with('\\');
  }
  return false;
}

Expected<ReadCloud> parse_obj(const FileBytes& file, const CloudUnits& units) { return ObjReader(file, units).read(); }

}  // namespace artcal
