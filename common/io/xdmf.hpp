/// XDMF: the XML file beside HDF5 files by which ParaView and VisIt draw fields on structured
/// curvilinear grids through time. The numbers stay in HDF5; this says where they are.
///
/// A grid has two node counts (a surface in space, or a plane) or three (a volume), the last index
/// running fastest, as in the arrays. A line is a surface of 1 x n nodes; it has no cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"

namespace pennon::xdmf {

/// A whole array of doubles. It has the shape of the nodes or cells, and one index more where there
/// are several numbers for each: ParaView's readers do not agree on parts of arrays.
struct Source {
  std::string file;   ///< the HDF5 file's name, in the folder of the XDMF file
  std::string array;  ///< its path there, from "/"
  hdf5::Shape shape;
};

enum class Center { node, cell };

/// A number for each node or cell, or in a volume three: on a surface give a vector's components
/// each by itself, since one of ParaView's two readers fails on vectors there.
struct Attribute {
  std::string name;
  Center center = Center::node;
  Source values;
};

struct Grid {
  double time = 0;
  hdf5::Shape nodes;  ///< along each direction
  Source points;      ///< x, y, z of each node
  std::vector<Attribute> attributes;
};

/// Writes the grids, in the order of their times, as one series with this name. Throws FileError.
void write(const std::filesystem::path& file, const std::string& name,
           const std::vector<Grid>& series);

}  // namespace pennon::xdmf
