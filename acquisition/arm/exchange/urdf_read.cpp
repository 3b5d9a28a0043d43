#include "acquisition/arm/exchange/urdf_read.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/number_range.h"
#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

std::string name_of(const pugi::xml_node& node) { return node.attribute("name").as_string(); }

std::string place_of_node(const TextFile& file, const pugi::xml_node& node) {
  const auto end = file.text.begin() + std::min<std::ptrdiff_t>(node.offset_debug(), std::ssize(file.text));
  return fmt::format("{}:{}", file.path.string(), std::count(file.text.begin(), end, '\n') + 1);
}

std::optional<double> number_of(std::string_view word) {
  const auto number = decimal_number(word);
  return number && is_in_range(*number) ? number : std::nullopt;
}

// Three numbers of an attribute, zeros where it is not there.
std::optional<Eigen::Vector3d> vector_of(const pugi::xml_attribute& attribute, const Eigen::Vector3d& otherwise) {
  if (!attribute) {
    return otherwise;
  }
  std::vector<double> numbers;
  const std::string text = attribute.as_string();
  constexpr std::string_view blanks = " \t\r\n";
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const auto number = number_of(std::string_view(text).substr(begin, end - begin));
    if (!number || numbers.size() == 3) {
      return std::nullopt;
    }
    numbers.push_back(*number);
    begin = text.find_first_not_of(blanks, end);
  }
  return numbers.size() == 3 ? std::optional<Eigen::Vector3d>(Eigen::Vector3d::Map(numbers.data())) : std::nullopt;
}

Expected<double> limit_of(const TextFile& file, const pugi::xml_node& joint, const char* key, double unit) {
  const pugi::xml_attribute attribute = joint.child("limit").attribute(key);
  const auto number = attribute ? number_of(attribute.as_string()) : std::optional(0.0);
  if (!number) {
    return bad_input(fmt::format("the limit `{}` of joint {} is {}, expected a number", key, in_quotes(name_of(joint)),
                                 in_quotes(attribute.as_string())),
                     place_of_node(file, joint));
  }
  return *number * unit;
}

Expected<ChainJoint> chain_joint(const TextFile& file, const pugi::xml_node& node) {
  ChainJoint joint;
  joint.name = name_of(node);
  const auto refused = [&](std::string why) {
    return bad_input(fmt::format("joint {} {}", in_quotes(joint.name), why), place_of_node(file, node));
  };
  const std::string type = node.attribute("type").as_string();
  const std::set<std::string> known{"revolute", "continuous", "prismatic", "fixed"};
  if (!known.contains(type)) {
    return refused(
        fmt::format("is of the type {}, which an arm's file cannot express; expected revolute, continuous, "
                    "prismatic or fixed",
                    in_quotes(type)));
  }
  if (node.child("mimic")) {
    return refused("follows another joint (mimic), which an arm's file cannot express");
  }
  const pugi::xml_node origin = node.child("origin");
  const auto at = vector_of(origin.attribute("xyz"), Eigen::Vector3d::Zero());
  const auto turn = vector_of(origin.attribute("rpy"), Eigen::Vector3d::Zero());
  const auto axis = vector_of(node.child("axis").attribute("xyz"), Eigen::Vector3d::UnitX());
  if (!at || !turn || !axis) {
    return refused(fmt::format("has {} that is not three numbers", !at     ? "an origin `xyz`"
                                                                   : !turn ? "an origin `rpy`"
                                                                           : "an axis"));
  }
  joint.parent_from_joint = {rotation_of_roll_pitch_yaw(*turn), units::metre * *at};
  joint.is_fixed = type == "fixed";
  joint.type = type == "prismatic" ? JointType::Prismatic : JointType::Revolute;
  if (!joint.is_fixed) {
    if (!(axis->norm() > 1e-6)) {
      return refused("has an axis of length zero");
    }
    joint.axis_in_joint = axis->normalized();
  }
  if (type == "revolute" || type == "prismatic") {
    const double unit = type == "prismatic" ? units::metre : 1.0;
    const auto low = limit_of(file, node, "lower", unit);
    const auto high = limit_of(file, node, "upper", unit);
    if (!low || !high) {
      return tl::unexpected(low ? high.error() : low.error());
    }
    if (*low < *high) {
      joint.lowest = *low;
      joint.highest = *high;
    }
  }
  return joint;
}

// An element of xacro, which expanded files have none of (although most of them still declare its namespace).
pugi::xml_node unexpanded(const pugi::xml_node& robot) {
  return robot.find_node([](const pugi::xml_node& node) {
    return std::string_view(node.name()).starts_with("xacro:") ||
           std::string_view(node.attribute("name").value()).find("${") != std::string_view::npos;
  });
}

/// The tree: of each link the joint that carries it.
struct Tree {
  std::map<std::string, pugi::xml_node> carried_by;
  std::set<std::string> links, parents;
};

Expected<Tree> tree_of(const TextFile& file, const pugi::xml_node& robot) {
  Tree tree;
  for (const pugi::xml_node& link : robot.children("link")) {
    tree.links.insert(name_of(link));
  }
  for (const pugi::xml_node& joint : robot.children("joint")) {
    const std::string parent = joint.child("parent").attribute("link").as_string();
    const std::string child = joint.child("child").attribute("link").as_string();
    for (const std::string& link : {parent, child}) {
      if (!tree.links.contains(link)) {
        return bad_input(
            fmt::format("joint {} names the link {}, which is not there", in_quotes(name_of(joint)), in_quotes(link)),
            place_of_node(file, joint));
      }
    }
    tree.parents.insert(parent);
    if (!tree.carried_by.emplace(child, joint).second) {
      return bad_input(fmt::format("joint {} is the second to carry the link {}; the links form no tree",
                                   in_quotes(name_of(joint)), in_quotes(child)),
                       place_of_node(file, joint));
    }
  }
  return tree;
}

// The link asked for, or the only one of these.
Expected<std::string> one_link(const TextFile& file, const Tree& tree, const std::string& asked,
                               const std::vector<std::string>& candidates, std::string_view option) {
  if (!asked.empty()) {
    return tree.links.contains(asked)
               ? Expected<std::string>(asked)
               : bad_input(fmt::format("there is no link {}; there are {}", in_quotes(asked),
                                       truncated(400, fmt::format("{}", fmt::join(tree.links, ", ")))),
                           file.path.string());
  }
  if (candidates.size() != 1) {
    return bad_input(fmt::format("{} links may be meant: {}; say which with {} LINK", candidates.size(),
                                 truncated(400, fmt::format("{}", fmt::join(candidates, ", "))), option),
                     file.path.string());
  }
  return candidates.front();
}

}  // namespace

Expected<JointChain> read_urdf(const std::filesystem::path& path, const ChainEnds& ends) {
  const auto file = read_text_file(path, largest::toml);
  if (!file) {
    return tl::unexpected(file.error());
  }
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(file->text.data(), file->text.size());
  if (!parsed) {
    const auto end = file->text.begin() + std::min<std::ptrdiff_t>(parsed.offset, std::ssize(file->text));
    return bad_input(fmt::format("this is no XML ({})", parsed.description()),
                     fmt::format("{}:{}", path.string(), std::count(file->text.begin(), end, '\n') + 1));
  }
  const pugi::xml_node robot = document.child("robot");
  if (!robot) {
    return bad_input(fmt::format("the root of the file is {}, expected `robot` of a URDF",
                                 in_quotes(document.document_element().name())),
                     path.string());
  }
  if (const pugi::xml_node macro = unexpanded(robot)) {
    return bad_input(
        fmt::format("{} is to be expanded first: xacro robot.urdf.xacro > robot.urdf", in_quotes(macro.name())),
        place_of_node(*file, macro));
  }
  const auto tree = tree_of(*file, robot);
  if (!tree) {
    return tl::unexpected(tree.error());
  }
  std::vector<std::string> roots, leaves;
  for (const std::string& link : tree->links) {
    if (!tree->carried_by.contains(link)) {
      roots.push_back(link);
    }
    if (!tree->parents.contains(link)) {
      leaves.push_back(link);
    }
  }
  const auto base = one_link(*file, *tree, ends.base, roots, "--base");
  const auto tip = one_link(*file, *tree, ends.tip, leaves, "--tip");
  if (!base || !tip) {
    return tl::unexpected(base ? tip.error() : base.error());
  }
  JointChain chain;
  chain.name = name_of(robot).empty() ? path.stem().string() : name_of(robot);
  chain.tip = *tip;
  for (std::string link = *tip; link != *base;) {
    const auto carrier = tree->carried_by.find(link);
    if (carrier == tree->carried_by.end() || chain.joints.size() > tree->links.size()) {
      return bad_input(fmt::format("no joints lead from the link {} to the link {}", in_quotes(*base), in_quotes(*tip)),
                       path.string());
    }
    auto joint = chain_joint(*file, carrier->second);
    if (!joint) {
      return tl::unexpected(joint.error());
    }
    chain.joints.push_back(std::move(*joint));
    link = carrier->second.child("parent").attribute("link").as_string();
  }
  std::reverse(chain.joints.begin(), chain.joints.end());
  return chain;
}

}  // namespace artcal
