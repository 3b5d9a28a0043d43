// What two sources of a layer declare alike in their unnamed namespaces is either a twin, which belongs into one place,
// or two things of one name, which is hard to read. The sources of a folder are compiled as one (cmake/layer.cmake), so
// that a call could take a neighbour's function without a word of the compiler: no source calls what a neighbour
// declares for itself.

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// What a source declares for itself: "function f(double,int)", "constant c", "type T", and where.
using Declared = std::map<std::string, std::set<std::string>>;

std::string without_blanks(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), ""); }

// Types of the parameters: names and default values do not make another function.
std::string parameter_types(const std::string& parameters) {
  std::string types, one;
  int depth = 0;
  const auto end_parameter = [&] {
    one = std::regex_replace(one, std::regex("^\\s+|\\s*=.*$"), "");
    std::smatch match;
    if (std::regex_match(one, match, std::regex("([\\s\\S]*[\\s&*>])\\w+\\s*")) &&
        !std::regex_match(one, std::regex("\\s*const\\s+\\w+\\s*"))) {
      one = match[1];
    }
    types += without_blanks(one) + ",";
    one.clear();
  };
  for (const char c : parameters) {
    depth += c == '<' || c == '(' || c == '{' ? 1 : c == '>' || c == ')' || c == '}' ? -1 : 0;
    if (c == ',' && depth == 0) {
      end_parameter();
    } else {
      one += c;
    }
  }
  end_parameter();
  return types;
}

// From the bracket at `open` to the one that closes it, without them.
std::string bracketed(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) {
      return text.substr(open + 1, i - open - 1);
    }
  }
  return {};
}

void add_declared(const std::string& text, const std::string& file, Declared& declared) {
  static const std::regex constant(R"(^(?:inline )?constexpr [^(]*?(\w+)(?:\[\w*\])? ?(?:=|\{))");
  static const std::regex type(R"(^(?:struct|class|enum class) (\w+)(?:[ :].*)?\{)");
  static const std::regex function(R"(^[A-Za-z_][\w:<>,&* ]*[ &*](\w+)\()");
  std::smatch match;
  for (std::size_t at = 0; at < text.size();
       at = text.find('\n', at) == std::string::npos ? text.size() : text.find('\n', at) + 1) {
    const std::string line = text.substr(at, text.find('\n', at) - at);
    if (std::regex_search(line, match, constant)) {
      declared["constant " + match[1].str()].insert(file);
    } else if (std::regex_search(line, match, type)) {
      declared["type " + match[1].str()].insert(file);
    } else if (!line.starts_with("using ") && std::regex_search(line, match, function)) {
      const std::size_t open = at + static_cast<std::size_t>(match.position(0) + match.length(0)) - 1;
      declared["function " + match[1].str() + "(" + parameter_types(bracketed(text, open)) + ")"].insert(file);
    }
  }
}

std::string unnamed_parts(const std::string& text) {
  std::string parts;
  for (std::size_t at = text.find("\nnamespace {\n"); at != std::string::npos; at = text.find("\nnamespace {\n", at)) {
    const std::size_t end = text.find("\n}  // namespace\n", at);
    parts += text.substr(at + 13, end - at - 13) + "\n";
    at = end;
  }
  return parts;
}

/// Layer of a source, from the root; empty outside of them.
std::string layer_of(const std::string& file) {
  for (const char* layer : {"app/commands", "artefacts/simulation", "artefacts/verification", "core", "acquisition",
                            "fitting", "artefacts", "identification", "app"}) {
    if (file.starts_with(std::string(layer) + "/")) {
      return layer;
    }
  }
  return {};
}

std::vector<std::string> shared_names(const fs::path& root) {
  std::map<std::string, Declared> layers;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string file = fs::relative(entry.path(), root).generic_string();
    if (file.starts_with("build/") || entry.path().extension() != ".cpp" || layer_of(file).empty()) {
      continue;
    }
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    add_declared(unnamed_parts(text.str()), file, layers[layer_of(file)]);
  }
  std::vector<std::string> found;
  for (const auto& [layer, declared] : layers) {
    for (const auto& [name, files] : declared) {
      if (files.size() > 1) {
        found.push_back(name + ": " + ::testing::PrintToString(files));
      }
    }
  }
  return found;
}

/// The unnamed functions and the text, without comments and quoted text, of a source.
struct Source {
  std::set<std::string> functions;
  std::string text;
};

std::string without_comments(const std::string& text) {
  static const std::regex comment_or_quote(R"re(//[^\n]*|"(?:\\.|[^"\\\n])*")re");
  return std::regex_replace(text, comment_or_quote, "");
}

Source source_of(const std::string& file_text) {
  static const std::regex function(R"(function (\w+)\(.*)");
  Declared declared;
  add_declared(unnamed_parts(file_text), "", declared);
  Source source{{}, without_comments(file_text)};
  std::smatch match;
  for (const auto& [name, files] : declared) {
    if (std::regex_match(name, match, function)) {
      source.functions.insert(match[1]);
    }
  }
  return source;
}

// Calls through an object or with the name of a class or namespace before it take what they name.
bool calls(const std::string& text, const std::string& function) {
  for (std::size_t at = text.find(function + "("); at != std::string::npos; at = text.find(function + "(", at + 1)) {
    const char before = at == 0 ? '\n' : text[at - 1];
    const bool is_arrow = at > 1 && text.compare(at - 2, 2, "->") == 0;
    if (std::isalnum(static_cast<unsigned char>(before)) == 0 &&
        std::string("_.:~").find(before) == std::string::npos && !is_arrow) {
      return true;
    }
  }
  return false;
}

std::vector<std::string> calls_of_neighbours(const fs::path& root) {
  std::map<fs::path, std::map<std::string, Source>> folders;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path file = fs::relative(entry.path(), root);
    if (entry.path().extension() == ".cpp" && !layer_of(file.generic_string()).empty()) {
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      folders[file.parent_path()][file.filename()] = source_of(text.str());
    }
  }
  std::vector<std::string> found;
  for (const auto& [folder, sources] : folders) {
    for (const auto& [file, source] : sources) {
      for (const std::string& function : source.functions) {
        for (const auto& [other, neighbour] : sources) {
          if (other != file && calls(neighbour.text, function)) {
            found.push_back((folder / file).string() + " declares " + function + "() for itself, " + other +
                            " calls it");
          }
        }
      }
    }
  }
  return found;
}

TEST(Names, OfASourceAreNotCalledByItsNeighbours) { EXPECT_THAT(calls_of_neighbours(ARTCAL_SOURCE_DIR), IsEmpty()); }

TEST(Names, TheCheckSeesACallOfANeighbour) {
  const testing::TemporaryFolder folder;
  fs::create_directories(folder.path() / "core");
  (void)folder.write("core/a.cpp", "\nnamespace {\n\nint size(double) {}\n\n}  // namespace\n");
  (void)folder.write("core/b.cpp", "int f() { return size(3); }  // not size(4)\n");
  (void)folder.write("core/c.cpp",
                     "int g() { return a.size(3) + b->size() + std::size(x) + resize(3); }  // size(4)\n");
  EXPECT_THAT(calls_of_neighbours(folder.path()), ElementsAre("core/a.cpp declares size() for itself, b.cpp calls it"));
}

TEST(Names, MeanOneThingInALayer) { EXPECT_THAT(shared_names(ARTCAL_SOURCE_DIR), IsEmpty()); }

TEST(Names, TheCheckSeesWhatIsShared) {
  const testing::TemporaryFolder folder;
  fs::create_directories(folder.path() / "core");
  fs::create_directories(folder.path() / "app/commands");
  const auto source = [](const std::string& inside) { return "\nnamespace {\n\n" + inside + "\n\n}  // namespace\n"; };
  (void)folder.write("core/a.cpp",
                     source("constexpr double width = 3.0;\nint f(const std::string& a, double b = 1.0) {}\n"
                            "struct Part {\n};\nvoid g(int i) {}\n"));
  (void)folder.write("core/b.cpp", source("constexpr int width = 2;\nint f(const std::string& name, double) {}\n"
                                          "struct Part {\n};\nvoid g(double i) {}\n"));
  (void)folder.write("app/c.cpp", source("constexpr int width = 2;\n"));
  (void)folder.write("app/commands/d.cpp", source("constexpr int width = 2;\n"));
  const std::string in_both = ::testing::PrintToString(std::set<std::string>{"core/a.cpp", "core/b.cpp"});
  EXPECT_THAT(shared_names(folder.path()),
              ElementsAre("constant width: " + in_both, "function f(conststd::string&,double,): " + in_both,
                          "type Part: " + in_both));
}

}  // namespace
}  // namespace artcal
