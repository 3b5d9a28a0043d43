#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/html.h"

namespace artcal {

/// Most series of a figure: as many as there are marks to tell them apart.
inline constexpr std::size_t max_series = 6;

/// A picture, and the same in words for who does not see it. All texts, no markup.
struct Figure {
  std::string title;
  std::string caption;          ///< the key numbers, and what symbols and dashes mean
  nlohmann::ordered_json data;  ///< with `kind`, by which app/report/web draws it
  bool tall = false;
};

enum class Mood { Good, Bad, Unsure };

/// A report as it is written, top to bottom.
class Sheet {
 public:
  void title(std::string_view text);
  void section(std::string_view text);
  void part(std::string_view text);
  void paragraph(std::string_view text);
  void note(std::string_view text);
  /// What the reader came for. Colour and frame repeat what the words say.
  void verdict(Mood mood, std::string_view headline, std::string_view text);
  void list(const std::vector<std::string>& texts);
  /// Pairs of a name and what is known of it; pairs without a value are left out.
  void facts(const std::vector<std::pair<std::string, std::string>>& facts);
  void table(const html::Table& table);
  void figure(const Figure& figure);

  [[nodiscard]] const std::string& markup() const { return markup_; }
  [[nodiscard]] const nlohmann::ordered_json& figures() const { return figures_; }

 private:
  std::string markup_;
  nlohmann::ordered_json figures_ = nlohmann::ordered_json::array();
};

}  // namespace artcal
