// Layers point down only: a folder includes what its library links, links have no cycle, and the
// picture in docs/architecture.md shows them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/source_folder.hpp"

namespace pennon::test {
namespace {

namespace fs = std::filesystem;

// The libraries of the build as pennon_library() wrote them down: folder, name, what it links.
struct Layers {
  std::map<std::string, std::set<std::string>> links;      // of a library
  std::map<std::string, std::set<std::string>> libraries;  // of a folder
  std::map<std::string, std::string> folder;               // of a library

  explicit Layers(std::istream& lines) {
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string of_folder, name, link;
      if (!(words >> of_folder >> name)) continue;
      folder[name] = of_folder;
      libraries[of_folder].insert(name);
      links[name];
      while (words >> link) links[name].insert(link);
    }
  }

  // A library and all below it; `open` holds what is above it.
  void collect(const std::string& library, std::set<std::string>& found,
               std::vector<std::string> open = {}) const {
    ASSERT_EQ(std::count(open.begin(), open.end(), library), 0) << library << " links itself";
    ASSERT_TRUE(links.contains(library)) << library << " is not a library of the project";
    if (!found.insert(library).second) return;
    open.push_back(library);
    for (const std::string& link : links.at(library)) collect(link, found, open);
  }

  // The folders that the files of one may include.
  std::set<std::string> below(const std::string& of_folder) const {
    std::set<std::string> found, folders;
    for (const std::string& library : libraries.at(of_folder)) collect(library, found);
    for (const std::string& library : found) folders.insert(folder.at(library));
    return folders;
  }

  // Includes of a folder that is neither its own nor below it.
  std::vector<std::string> includes_upward(const std::string& of_folder,
                                           std::istream& source) const {
    static const std::regex include(R"re(^#include "(([\w/]+)/\w+\.hpp)")re");
    const std::set<std::string> allowed = below(of_folder);
    std::vector<std::string> found;
    std::smatch match;
    for (std::string line; std::getline(source, line);)
      if (std::regex_search(line, match, include) && !allowed.contains(match[2]))
        found.push_back(match[1]);
    return found;
  }
};

Layers layers_of_the_build() {
  std::ifstream file(PENNON_LAYERS_FILE);
  return Layers(file);
}

TEST(Layers, HaveNoCycleAndEveryFolderWithSourcesIsOne) {
  const Layers layers = layers_of_the_build();
  for (const auto& [library, links] : layers.links) {
    std::set<std::string> found;
    layers.collect(library, found);
  }
  for (const char* top : {"common", "lsa", "modes", "dns", "analysis", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / top)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      EXPECT_TRUE(layers.libraries.contains(
          fs::relative(entry.path().parent_path(), source_folder()).string()))
          << entry.path();
    }
}

TEST(Layers, IncludeOnlyWhatIsBelowThem) {
  const Layers layers = layers_of_the_build();
  ASSERT_GT(layers.libraries.size(), 20u);
  int files = 0;
  for (const auto& [folder, libraries] : layers.libraries)
    for (const auto& entry : fs::directory_iterator(source_folder() / folder)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      if (entry.path().filename() == "main.cpp" || entry.path().filename() == "global_main.cpp")
        continue;  // programs of their own, with libraries of their own
      std::ifstream source(entry.path());
      for (const std::string& include : layers.includes_upward(folder, source))
        ADD_FAILURE() << entry.path() << " includes " << include << ", which is not below "
                      << folder;
      ++files;
    }
  EXPECT_GT(files, 300);
}

// What docs/architecture.md draws: each arrow from a library to one that it links.
Layers layers_of_the_picture() {
  static const std::regex arrow(R"re(^ *(\w+)(?:\[.*\])? --> (\w+))re");
  std::ifstream page(source_folder() / "docs/architecture.md");
  std::stringstream lines;
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_search(line, match, arrow)) {
      lines << "picture pennon::" << match[1] << " pennon::" << match[2] << '\n';
      lines << "picture pennon::" << match[2] << '\n';
    }
  return Layers(lines);
}

// What a library stands on, but for common/, which the picture leaves out.
std::set<std::string> drawn_below(const Layers& layers, const std::string& library) {
  std::set<std::string> found;
  layers.collect(library, found);
  std::erase_if(found, [](const std::string& name) { return name.starts_with("pennon::common"); });
  return found;
}

TEST(Layers, AreThoseThatThePictureInTheDocsShows) {
  const Layers layers = layers_of_the_build(), picture = layers_of_the_picture();
  for (const auto& [library, links] : layers.links) {
    if (library.starts_with("pennon::common")) continue;
    ASSERT_TRUE(picture.links.contains(library)) << "docs/architecture.md lacks " << library;
    EXPECT_EQ(drawn_below(picture, library), drawn_below(layers, library)) << library;
  }
  for (const auto& [name, links] : picture.links)
    if (name != "pennon::global_main") {  // the program of the global modes
      EXPECT_TRUE(layers.links.contains(name)) << name << " is no library of the build";
    }
}

// The test can fail.
TEST(Layers, NoticeAnIncludeThatPointsUpAndACycle) {
  std::istringstream lines("dns/grid pennon::grid\ndns/run pennon::run pennon::grid\n");
  const Layers layers(lines);
  std::istringstream up("#include <vector>\n#include \"dns/run/settings.hpp\"\n"),
      down("#include \"dns/grid/field.hpp\"\n#include \"dns/run/settings.hpp\"\n");
  EXPECT_EQ(layers.includes_upward("dns/grid", up),
            std::vector<std::string>{"dns/run/settings.hpp"});
  EXPECT_TRUE(layers.includes_upward("dns/run", down).empty());
}

// The global modes share the discretisation with the simulation, not its runs, and no PETSc.
TEST(Layers, KeepTheGlobalModesFreeOfTheSimulationsRunAndOfPetsc) {
  const Layers layers = layers_of_the_build();
  const std::set<std::string> below = layers.below("modes/global/study");
  EXPECT_TRUE(below.contains("dns/fluid/equations"));
  for (const char* other : {"dns/run", "dns/coupling", "dns/fluid", "common/petsc"})
    EXPECT_FALSE(below.contains(other)) << other;
}

}  // namespace
}  // namespace pennon::test
