/// Reads an XDMF file as ParaView would and says where it contradicts itself or its HDF5 files.
#pragma once

#include <fmt/format.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"

namespace pennon::test {

struct XdmfSummary {
  std::vector<double> times;
  std::vector<std::string> attributes;  ///< of the first grid, as "velocity: Vector at Node"
  std::vector<std::string> faults;      ///< none in a good file
};

namespace detail {

using Tree = boost::property_tree::ptree;

inline hdf5::Shape dimensions_of(const Tree& element) {
  std::istringstream stream(element.get<std::string>("<xmlattr>.Dimensions"));
  hdf5::Shape dimensions;
  for (hsize_t extent = 0; stream >> extent;) dimensions.push_back(extent);
  return dimensions;
}

class XdmfCheck {
 public:
  explicit XdmfCheck(const std::filesystem::path& file) : folder_(file.parent_path()) {
    Tree tree;
    read_xml(file.string(), tree);  // throws where it is not well-formed
    const Tree& series = tree.get_child("Xdmf.Domain.Grid");
    for (const auto& [tag, grid] : series)
      if (tag == "Grid") check_grid(grid);
  }
  XdmfSummary summary;

 private:
  void expect(bool holds, const std::string& fault) {
    if (!holds) summary.faults.push_back(fault);
  }
  void check_grid(const Tree& grid) {
    summary.times.push_back(grid.get<double>("Time.<xmlattr>.Value"));
    const hdf5::Shape nodes = dimensions_of(grid.get_child("Topology"));
    expect(grid.get<std::string>("Topology.<xmlattr>.TopologyType") ==
               fmt::format("{}DSMesh", nodes.size()),
           "the topology's type does not go with its dimensions");
    const std::string points = grid.get<std::string>("Geometry.<xmlattr>.GeometryType");
    check_item(grid.get_child("Geometry.DataItem"), nodes, points.size(), points);
    hdf5::Shape cells = nodes;
    for (hsize_t& extent : cells) --extent;
    for (const auto& [tag, element] : grid) {
      if (tag != "Attribute") continue;
      const auto name = element.get<std::string>("<xmlattr>.Name");
      const auto type = element.get<std::string>("<xmlattr>.AttributeType");
      const auto center = element.get<std::string>("<xmlattr>.Center");
      if (summary.times.size() == 1)
        summary.attributes.push_back(fmt::format("{}: {} at {}", name, type, center));
      check_item(element.get_child("DataItem"), center == "Node" ? nodes : cells,
                 type == "Vector" ? 3 : 1, name);
    }
  }
  void check_item(const Tree& item, hdf5::Shape expected, hsize_t components,
                  const std::string& name) {
    if (components > 1) expected.push_back(components);
    expect(dimensions_of(item) == expected, name + " has other dimensions than its grid");
    const std::string& source = item.data();
    const std::size_t colon = source.find(':');
    const hdf5::Reader file(folder_ / source.substr(0, colon));
    expect(file.shape(source.substr(colon + 1)) == dimensions_of(item),
           name + " has other dimensions than " + source);
  }

  std::filesystem::path folder_;
};

}  // namespace detail

inline XdmfSummary check_xdmf(const std::filesystem::path& file) {
  return detail::XdmfCheck(file).summary;
}

}  // namespace pennon::test
