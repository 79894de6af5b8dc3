/// Coloured surfaces in space, as a picture of what a flag looks like and how it is strained.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pennon::analysis {

/// A grid of nodes in space with a value at each: `rows` of `columns`.
struct Surface {
  std::size_t rows = 0, columns = 0;
  std::vector<double> x, y, z, values;
};

struct SurfacePicture {
  std::string x_label, y_label, z_label, value_label;  ///< enhanced text, as in figure.hpp
  std::vector<Surface> surfaces;
};

/// Draws the surfaces in perspective, with equal scales along all axes and the values in bands of
/// colour. Writes `stem`.png, whole or not at all, and returns its name. Throws InputError
/// where a surface has another number of values than nodes, FileError as draw() of figure.hpp does.
std::filesystem::path draw(const SurfacePicture&, const std::filesystem::path& stem);

}  // namespace pennon::analysis
