/// HDF5 files of named arrays of doubles with attributes: written whole or not at all, and read
/// with every array checked before anything is allocated for it.
#pragma once

#include "common/io/hdf5_reader.hpp"
#include "common/io/hdf5_writer.hpp"
