/// Reads a TOML case file into the variables a Schema binds, and finds every fault of it at once.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/case/schema.hpp"
#include "common/errors.hpp"

namespace pennon {

/// Gathers the faults of an input, each with the place of the key it is about.
class Faults {
 public:
  /// `places`: "table.key" to "file:line"; `found`: those there are already.
  Faults(std::string file, std::map<std::string, std::string> places,
         std::vector<InputFault> found = {})
      : file_(std::move(file)), places_(std::move(places)), faults_(std::move(found)) {}

  /// Adds a fault about a key ("lsa.k_x"), or about the whole file where the case lacks it.
  void about(const std::string& key, std::string what);
  bool has_key(const std::string& key) const { return places_.contains(key); }
  /// Throws InputError with all faults, in the order of their lines and then of the overrides, if
  /// there is any.
  void raise() const;
  std::size_t count() const { return faults_.size(); }
  /// Faults that were found later, about keys by their names: each with the place of its key.
  InputError located(const InputError&) const;

 private:
  std::string file_;
  std::map<std::string, std::string> places_;
  std::vector<InputFault> faults_;
};

/// Reads `file` and then the overrides ("table.key=value", as given with --set) into the schema's
/// variables. A value that is not TOML is taken as text, so `lsa.added_mass=lamb` needs no quotes.
/// Returns the gathered faults, so that the caller can add those between keys before raise().
/// Throws InputError at once where there is nothing to read keys from: an unreadable file, a
/// folder, a file over 1 MiB, text that is not TOML (file:line and the parser's words).
Faults read_case_file(const std::filesystem::path& file, std::span<const std::string> overrides,
                      Schema& schema);

/// The same, of text; `name` stands for the file in messages.
Faults read_case_text(std::string_view text, const std::string& name,
                      std::span<const std::string> overrides, Schema& schema);

}  // namespace pennon
