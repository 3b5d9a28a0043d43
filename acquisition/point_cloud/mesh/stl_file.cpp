#include "acquisition/point_cloud/mesh/stl_file.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "acquisition/coincidence/coincident_points.h"
#include "acquisition/point_cloud/binary_columns.h"
#include "acquisition/point_cloud/cloud_builder.h"
#include "acquisition/point_cloud/text_rows.h"

namespace artcal {
namespace {

constexpr std::size_t header_size = 84;      // a text of 80 bytes and the number of triangles
constexpr std::size_t triangle_size = 50;    // a normal, three vertices, two bytes
constexpr std::size_t shortest_vertex = 13;  // "vertex 1 2 3\n"

std::size_t promised_triangles(std::string_view bytes) {
  return static_cast<std::size_t>(read_number(bytes.data() + header_size - 4, NumberType::UInt32, ByteOrder::Little));
}

// A text has no such number of triangles: four letters are more than half a billion.
bool is_binary_stl(std::string_view bytes) {
  return bytes.size() > header_size && bytes.size() == header_size + triangle_size * promised_triangles(bytes);
}

bool is_word(std::string_view word, std::string_view expected) {
  return word.size() == expected.size() && std::equal(word.begin(), word.end(), expected.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

// Every vertex is there once for each of its triangles.
Expected<ReadCloud> finish(CloudBuilder&& builder, const FileBytes& file, std::size_t triangles) {
  return std::move(builder).finish(file, {}).map([&](PointCloud&& cloud) {
    merge_equal_points(cloud);
    std::string told = fmt::format("the {} vertices of {} triangles (STL)", cloud.points.cols(), triangles);
    return ReadCloud{std::move(cloud), std::move(told)};
  });
}

Expected<ReadCloud> parse_binary(const FileBytes& file, const CloudUnits& units) {
  const std::size_t triangles = promised_triangles(file.bytes);
  CloudBuilder builder(units, 3, 3 * triangles);
  builder.note_single_precision();
  for (std::size_t i = 0; i < triangles; ++i) {
    // Behind the normal.
    const char* at = file.bytes.data() + header_size + triangle_size * i + 3 * sizeof(float);
    for (int vertex = 0; vertex < 3; ++vertex) {
      std::array<double, 3> point{};
      for (double& coordinate : point) {
        coordinate = read_number(at, NumberType::Float32, ByteOrder::Little);
        at += sizeof(float);
      }
      builder.add(point.data());
    }
  }
  return finish(std::move(builder), file, triangles);
}

/// Reads an STL in text, line by line.
class StlText {
 public:
  StlText(const FileBytes& file, const CloudUnits& units)
      : file_(file),
        rows_(file.bytes, file.path.string(), 1, TextRows::Separator::Blanks),
        builder_(units, 3, std::min(lines_of(file), file.bytes.size() / shortest_vertex + 1)) {}

  Expected<ReadCloud> read() {
    while (rows_.next()) {
      if (auto taken = take(rows_.fields().front()); !taken) {
        return tl::unexpected(taken.error());
      }
    }
    if (place_ != Place::Outside) {
      return bad_input("the file ends within a solid, expected endsolid; is it truncated?", rows_.where());
    }
    return finish(std::move(builder_), file_, triangles_);
  }

 private:
  enum class Place { Outside, InSolid, InFacet, InLoop };

  struct Step {
    std::string_view word;
    Place from, to;
  };

  static std::size_t lines_of(const FileBytes& file) {
    return static_cast<std::size_t>(std::count(file.bytes.begin(), file.bytes.end(), '\n')) + 1;
  }

  Expected<void> take(std::string_view word) {
    static constexpr std::array<Step, 6> steps{{{"solid", Place::Outside, Place::InSolid},
                                                {"facet", Place::InSolid, Place::InFacet},
                                                {"outer", Place::InFacet, Place::InLoop},
                                                {"endloop", Place::InLoop, Place::InFacet},
                                                {"endfacet", Place::InFacet, Place::InSolid},
                                                {"endsolid", Place::InSolid, Place::Outside}}};
    if (is_word(word, "vertex")) {
      return take_vertex();
    }
    const auto step =
        std::find_if(steps.begin(), steps.end(), [&](const Step& each) { return is_word(word, each.word); });
    if (step == steps.end() || step->from != place_) {
      return bad_input(fmt::format("the line is not what comes next in an STL, expected {}", expected()),
                       rows_.where());
    }
    if (step->word == "endloop" && vertices_ != 3) {
      return bad_input(fmt::format("the facet has {} vertices, expected 3", vertices_), rows_.where());
    }
    if (step->word == "outer") {
      vertices_ = 0;
      ++triangles_;
    }
    place_ = step->to;
    return {};
  }

  Expected<void> take_vertex() {
    if (place_ != Place::InLoop || rows_.fields().size() != 4) {
      return bad_input(place_ != Place::InLoop
                           ? fmt::format("the line is a vertex outside a loop, expected {}", expected())
                           : fmt::format("the vertex has {} numbers, expected 3", rows_.fields().size() - 1),
                       rows_.where());
    }
    std::array<double, 3> point{};
    if (auto read = rows_.numbers(columns_, point.data()); !read) {
      return read;
    }
    ++vertices_;
    builder_.add(point.data());
    return {};
  }

  [[nodiscard]] const char* expected() const {
    switch (place_) {
      case Place::Outside: return "solid";
      case Place::InSolid: return "facet or endsolid";
      case Place::InFacet: return "outer loop or endfacet";
      case Place::InLoop: break;
    }
    return "vertex or endloop";
  }

  const std::vector<std::size_t> columns_{1, 2, 3};
  const FileBytes& file_;
  TextRows rows_;
  CloudBuilder builder_;
  Place place_ = Place::Outside;
  std::size_t vertices_ = 0;  // of this facet
  std::size_t triangles_ = 0;
};

bool is_text_stl(std::string_view bytes) {
  TextRows rows(bytes, "", 1, TextRows::Separator::Blanks);
  return rows.next() && is_word(rows.fields().front(), "solid") && rows.next() &&
         (is_word(rows.fields().front(), "facet") || is_word(rows.fields().front(), "endsolid"));
}

}  // namespace

bool looks_like_stl(std::string_view bytes) { return is_binary_stl(bytes) || is_text_stl(bytes); }

Expected<ReadCloud> parse_stl(const FileBytes& file, const CloudUnits& units) {
  if (is_binary_stl(file.bytes)) {
    return parse_binary(file, units);
  }
  if (is_text_stl(file.bytes)) {
    return StlText(file, units).read();
  }
  const std::size_t size = file.bytes.size();
  if (size < header_size || file.bytes.find('\0') == std::string::npos) {
    return bad_input("the name ends in .stl, but the file begins neither as an STL in text nor as one in binary",
                     file.path.string());
  }
  return bad_input(
      fmt::format(
          "as a binary STL the file promises {0} triangles, {1} + {2} x {0} bytes, but it has {3}; is it truncated?",
          promised_triangles(file.bytes), header_size, triangle_size, size),
      file.path.string());
}

}  // namespace artcal
