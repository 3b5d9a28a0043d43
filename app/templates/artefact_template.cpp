#include "app/templates/artefact_template.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/templates/answers.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr const char* artefact_head =
    R"(# A {type} to start from. Its values are made up: put those of your certificate in their places, at the reference
# temperature of 20 degC. Every key is described in docs/files.md, "artefact.toml"; a digital certificate (DCC) is named
# by dcc = "certificate.xml" instead.
schema = "artcal-artefact/1"
name = {name}
type = {quoted_type}
note = "Made up, as an example: no object has this certificate."

# Of the bare lengths in this file: mm, um, m, in.
units = {{ length = {length} }}
)";

constexpr const char* material = R"(
# Thermal expansion and its expanded uncertainty, 1/K: 11.5e-6 is steel.
material = "steel"
expansion_per_K = 11.5e-6
U_expansion_per_K = 1e-6
k_expansion = 2
)";

constexpr const char* certificate = R"toml(
[certificate]
number = "EX-0001"
laboratory = "Example Laboratory (made up)"
date = 2026-03-02
# valid_until = 2028-03-01
)toml";

/// What a type has: how many features, and the text of them.
struct TypeText {
  const char* type;
  int features, lowest, highest;
  bool expands;
  std::string (*text)(int features, double unit);
};

std::string rounded_number(double mm, double unit) { return toml_number(std::round(mm / unit * 1e9) / 1e9); }

std::string balls_on_a_bar(int count, double unit) {
  std::string text =
      "\n# The balls, and the certified distances of their centres with expanded uncertainties.\n"
      "[uncertainty]\ndiameter = { U = \"0.3 um\", k = 2 }\n";
  for (int i = 1; i <= count; ++i) {
    text +=
        fmt::format("\n[[feature]]\nname = \"{}\"\nkind = \"sphere\"\ndiameter = {}\n", i, rounded_number(25.4, unit));
  }
  for (int i = 2; i <= count; ++i) {
    text += fmt::format("\n[[distance]]\nbetween = [\"1\", \"{}\"]\nvalue = {}\nU = \"0.8 um\"\nk = 2\n", i,
                        rounded_number(1000.0 * (i - 1) / (count - 1), unit));
  }
  return text;
}

// On a grid of 100 mm, row by row.
std::string on_a_grid(int count, double unit, const char* kind, const std::string& rest) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += fmt::format("\n[[feature]]\nname = \"{}\"\nkind = \"{}\"\nat = [{}, {}, 0]\n{}", i + 1, kind,
                        rounded_number(100.0 * (i % columns), unit), rounded_number(100.0 * (i / columns), unit), rest);
  }
  return text;
}

std::string balls_on_a_plate(int count, double unit) {
  return "\n# Certified coordinates in the plate's own frame; L is the distance from its origin.\n[uncertainty]\n"
         "at = { rule = \"sqrt(a^2 + (b*L)^2)\", a = \"0.5 um\", b = \"1.2 um/m\", k = 2 }\n"
         "diameter = { U = \"0.3 um\", k = 2 }\n" +
         on_a_grid(count, unit, "sphere", fmt::format("diameter = {}\n", rounded_number(22.0, unit)));
}

std::string seats_on_a_plate(int count, double unit) {
  return "\n# Where the centre of the tip comes to rest in each cone.\n[uncertainty]\nat = { U = \"1.5 um\", k = 2 "
         "}\n" +
         on_a_grid(count, unit, "point", "");
}

std::string faces_of_a_step_gauge(int count, double unit) {
  std::string text =
      "\n# Faces along x; odd ones look back, even ones ahead. L is the distance from the first face.\n"
      "[uncertainty]\nat = { rule = \"a + b*L\", a = \"0.2 um\", b = \"0.5 um/m\", k = 2 }\n";
  for (int i = 0; i < count; ++i) {
    text += fmt::format("\n[[feature]]\nname = \"{}\"\nkind = \"plane\"\nat = [{}, 0, 0]\nnormal = [{}, 0, 0]\n", i + 1,
                        rounded_number(20.0 * i, unit), i % 2 == 0 ? -1 : 1);
  }
  return text;
}

std::string a_sphere(int, double unit) {
  return fmt::format(
      "\n# `form` is the certified sphericity.\n[[feature]]\nname = \"ball\"\nkind = \"sphere\"\ndiameter = "
      "{}\nU_diameter = \"0.2 um\"\nform = {}\nU_form = \"0.05 um\"\nk = 2\n",
      rounded_number(25.0, unit), rounded_number(0.00008, unit));
}

std::string a_plane(int, double unit) {
  return fmt::format(
      "\n# Where the plane stands is found in each placement. `form` is its certified flatness.\n[[feature]]\n"
      "name = \"top\"\nkind = \"plane\"\nform = {}\nU_form = \"0.9 um\"\nk = 2\n",
      rounded_number(0.0032, unit));
}

std::string a_gauge_block(int, double unit) {
  return fmt::format(
      "\n[[feature]]\nname = \"left\"\nkind = \"plane\"\n\n[[feature]]\nname = \"right\"\nkind = \"plane\"\n\n"
      "[[distance]]\nbetween = [\"left\", \"right\"]\nvalue = {}\nU = \"0.3 um\"\nk = 2\n",
      rounded_number(500.0, unit));
}

std::string a_telescoping_bar(int, double) {
  return "\n# The fixed ball; lengths from it to the tip are in the readings. `U` is that of each measured length.\n"
         "[[feature]]\nname = \"ball\"\nkind = \"anchor\"\nU = \"1.2 um\"\nk = 2\n";
}

constexpr std::array type_texts{TypeText{"ball bar", 4, 2, 100, true, balls_on_a_bar},
                                TypeText{"sphere plate", 9, 3, 400, true, balls_on_a_plate},
                                TypeText{"sphere", 1, 1, 1, true, a_sphere},
                                TypeText{"plane", 1, 1, 1, true, a_plane},
                                TypeText{"seat plate", 6, 3, 400, true, seats_on_a_plate},
                                TypeText{"step gauge", 8, 2, 200, true, faces_of_a_step_gauge},
                                TypeText{"gauge block", 2, 2, 2, true, a_gauge_block},
                                TypeText{"telescoping bar", 1, 1, 1, false, a_telescoping_bar}};

// A word of a command line: "ball-bar" of "ball bar".
std::string type_word(std::string type) {
  std::replace(type.begin(), type.end(), ' ', '-');
  return type;
}

std::vector<std::string> type_words() {
  std::vector<std::string> words;
  for (const TypeText& each : type_texts) {
    words.push_back(type_word(each.type));
  }
  return words;
}

}  // namespace

std::vector<Choice> ArtefactTemplate::choices() {
  return {{"--name", "NAME", "name of the artefact", &name, {}, is_name, "a name"},
          {"--type", "", "type of the artefact", &type, type_words(), nullptr, ""},
          {"--features",
           "N",
           "number of its balls, seats or faces",
           &features,
           {},
           [](const std::string& n) { return n == "default" || is_count(n, 1, 400); },
           "a number, or default: by its type",
           1,
           400},
          {"--length-unit", "", "unit of lengths", &length_unit, length_unit_names(), nullptr, ""}};
}

Expected<std::string> ArtefactTemplate::text() const {
  const TypeText& chosen =
      *std::find_if(type_texts.begin(), type_texts.end(), [&](const TypeText& t) { return type_word(t.type) == type; });
  const int count = features == "default" ? chosen.features : std::stoi(features);
  if (count < chosen.lowest || count > chosen.highest) {
    return wrong_usage(fmt::format("--features is {}, but a {} has {}", count, chosen.type,
                                   chosen.lowest == chosen.highest
                                       ? fmt::format("{}", chosen.lowest)
                                       : fmt::format("{} to {} here", chosen.lowest, chosen.highest)));
  }
  return fmt::format(fmt::runtime(artefact_head), fmt::arg("type", chosen.type), fmt::arg("name", toml_text(name)),
                     fmt::arg("quoted_type", toml_text(chosen.type)), fmt::arg("length", toml_text(length_unit))) +
         (chosen.expands ? material : "") + certificate + chosen.text(count, *artcal::length_unit(length_unit));
}

}  // namespace artcal
