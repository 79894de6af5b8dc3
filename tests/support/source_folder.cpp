#include "tests/support/source_folder.hpp"

namespace pennon::test {

std::filesystem::path source_folder() {
  return PENNON_SOURCE_DIR;
}

}  // namespace pennon::test
