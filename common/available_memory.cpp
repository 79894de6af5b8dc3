#include "common/available_memory.hpp"

#include <fstream>
#include <string>

namespace pennon {

std::optional<double> available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kilobytes = 0;
  while (file >> word)
    if (word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  return std::nullopt;
}

}  // namespace pennon
