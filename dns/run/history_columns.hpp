/// The columns of a history: their names in history.csv, and what history.h5 says of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"

namespace pennon::dns {

struct HistoryColumn {
  const char* name;
  const char* meaning;
};

inline std::vector<std::string> names_of(std::span<const HistoryColumn> columns) {
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const HistoryColumn& column : columns) names.emplace_back(column.name);
  return names;
}

/// `columns`, the names in their order separated by commas, and each column's meaning under its
/// name.
inline hdf5::Attributes attributes_of(std::span<const HistoryColumn> columns) {
  hdf5::Attributes attributes;
  std::string names;
  for (const HistoryColumn& column : columns) {
    if (!names.empty()) names += ',';
    names += column.name;
    attributes[column.name] = std::string(column.meaning);
  }
  attributes["columns"] = names;
  return attributes;
}

}  // namespace pennon::dns
