/// The manual page of the command line, made from its declaration.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pennon::app {

/// The page in the language of man(7). `version`: what stands in its footer.
std::string manual_page(const CLI::App& program, const std::string& version);

}  // namespace pennon::app
