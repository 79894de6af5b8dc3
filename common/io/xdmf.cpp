#include "common/io/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "common/io/atomic_file.hpp"

namespace pennon::xdmf {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  return result;
}

hdf5::Shape cells_of(const hdf5::Shape& nodes) {
  hdf5::Shape cells = nodes;
  for (hsize_t& extent : cells) {
    assert(extent > 1);
    --extent;
  }
  return cells;
}

std::string item(const Source& source) {
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"{}\">{}:{}"
      "</DataItem>",
      fmt::join(source.shape, " "), escaped(source.file), escaped(source.array));
}

// How many numbers an array holds for each place.
hsize_t components(const Source& source, const hdf5::Shape& places) {
  assert(std::equal(places.begin(), places.end(), source.shape.begin()));
  assert(source.shape.size() <= places.size() + 1);
  return source.shape.size() == places.size() ? 1 : source.shape.back();
}

std::string text_of(const Grid& grid, const std::string& name) {
  assert(grid.nodes.size() == 2 || grid.nodes.size() == 3);
  assert(components(grid.points, grid.nodes) == 3);
  std::string text = fmt::format(
      "      <Grid Name=\"{}\" GridType=\"Uniform\">\n"
      "        <Time Value=\"{}\"/>\n"
      "        <Topology TopologyType=\"{}DSMesh\" Dimensions=\"{}\"/>\n"
      "        <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
      escaped(name), grid.time, grid.nodes.size(), fmt::join(grid.nodes, " "), item(grid.points));
  for (const Attribute& attribute : grid.attributes) {
    const bool is_of_nodes = attribute.center == Center::node;
    const hsize_t numbers =
        components(attribute.values, is_of_nodes ? grid.nodes : cells_of(grid.nodes));
    assert(numbers == 1 || (numbers == 3 && grid.nodes.size() == 3));
    text += fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
        escaped(attribute.name), numbers == 1 ? "Scalar" : "Vector", is_of_nodes ? "Node" : "Cell",
        item(attribute.values));
  }
  return text + "      </Grid>\n";
}

}  // namespace

void write(const std::filesystem::path& file, const std::string& name,
           const std::vector<Grid>& series) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
      escaped(name));
  for (const Grid& grid : series) text += text_of(grid, name);
  write_file(file, text + "    </Grid>\n  </Domain>\n</Xdmf>\n");
}

}  // namespace pennon::xdmf
