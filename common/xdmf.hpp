/// XDMF: the XML file beside HDF5 files by which ParaView and VisIt draw fields on structured
/// curvilinear grids through time. The numbers stay in HDF5; this says where they are.
///
/// A grid has two node counts (a surface in space, or a plane) or three (a volume), the last index
/// running fastest, as in the arrays. A line is a surface of 1 x n nodes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/hdf5.hpp"

namespace pennon::xdmf {

/// A box within an array of doubles.
struct Block {
  std::string file;          ///< the HDF5 file's name, in the folder of the XDMF file
  std::string array;         ///< its path there, from "/"
  hdf5::Shape shape;         ///< of the whole array
  hdf5::Shape start, count;  ///< of the box along each index; empty: the whole array
};

/// The part of an array that one index of its first dimension holds.
Block row_of(Block whole, hsize_t row);

enum class Center { node, cell };

/// A number or three for each node or cell.
struct Attribute {
  std::string name;
  Center center = Center::node;
  Block values;
};

struct Grid {
  double time = 0;
  hdf5::Shape nodes;  ///< along each direction
  Block points;       ///< x, y, z of each node; x, y on a plane
  std::vector<Attribute> attributes;
};

/// Writes the grids, in the order of their times, as one series with this name. The blocks' values
/// must be as many as the nodes or cells ask for. Throws FileError.
void write(const std::filesystem::path& file, const std::string& name,
           const std::vector<Grid>& series);

}  // namespace pennon::xdmf
