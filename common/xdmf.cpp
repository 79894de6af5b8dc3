#include "common/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "common/atomic_file.hpp"

namespace pennon::xdmf {
namespace {

hsize_t product(const hdf5::Shape& shape) {
  hsize_t result = 1;
  for (const hsize_t extent : shape) result *= extent;
  return result;
}

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
  for (hsize_t& extent : cells) extent = std::max<hsize_t>(extent - 1, 1);
  return cells;
}

// The values of a block, `components` for each place of `places`.
std::string item(const Block& block, hdf5::Shape places, hsize_t components) {
  if (components > 1) places.push_back(components);
  const std::string array = fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" "
      "Dimensions=\"{}\">{}:{}</DataItem>",
      fmt::join(block.shape, " "), escaped(block.file), escaped(block.array));
  if (block.start.empty() && block.shape == places) return array;
  const std::size_t rank = block.shape.size();
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0}\">"
      "<DataItem Format=\"XML\" NumberType=\"Int\" Dimensions=\"3 {1}\">{2} {3} {4}</DataItem>"
      "{5}</DataItem>",
      fmt::join(places, " "), rank,
      fmt::join(block.start.empty() ? hdf5::Shape(rank, 0) : block.start, " "),
      fmt::join(hdf5::Shape(rank, 1), " "),
      fmt::join(block.start.empty() ? block.shape : block.count, " "), array);
}

hsize_t values_in(const Block& block) {
  return product(block.start.empty() ? block.shape : block.count);
}

std::string text_of(const Grid& grid, const std::string& name) {
  assert(grid.nodes.size() == 2 || grid.nodes.size() == 3);
  const hsize_t coordinates = values_in(grid.points) / product(grid.nodes);
  assert(values_in(grid.points) == coordinates * product(grid.nodes));
  assert(coordinates == 2 || coordinates == 3);
  std::string text = fmt::format(
      "      <Grid Name=\"{}\" GridType=\"Uniform\">\n"
      "        <Time Value=\"{}\"/>\n"
      "        <Topology TopologyType=\"{}DSMesh\" Dimensions=\"{}\"/>\n"
      "        <Geometry GeometryType=\"{}\">{}</Geometry>\n",
      escaped(name), grid.time, grid.nodes.size(), fmt::join(grid.nodes, " "),
      coordinates == 3 ? "XYZ" : "XY", item(grid.points, grid.nodes, coordinates));
  for (const Attribute& attribute : grid.attributes) {
    const bool is_of_nodes = attribute.center == Center::node;
    const hdf5::Shape places = is_of_nodes ? grid.nodes : cells_of(grid.nodes);
    const hsize_t components = values_in(attribute.values) / product(places);
    assert(values_in(attribute.values) == components * product(places));
    assert(components == 1 || components == 3);
    text += fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
        escaped(attribute.name), components == 1 ? "Scalar" : "Vector",
        is_of_nodes ? "Node" : "Cell", item(attribute.values, places, components));
  }
  return text + "      </Grid>\n";
}

}  // namespace

Block row_of(Block whole, hsize_t row) {
  assert(!whole.shape.empty() && row < whole.shape[0]);
  whole.start.assign(whole.shape.size(), 0);
  whole.start[0] = row;
  whole.count = whole.shape;
  whole.count[0] = 1;
  return whole;
}

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
