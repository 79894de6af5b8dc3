/// The project's folder, for the data that a test reads wherever it runs.
#pragma once

#include <filesystem>

namespace pennon::test {

std::filesystem::path source_folder();

}  // namespace pennon::test
