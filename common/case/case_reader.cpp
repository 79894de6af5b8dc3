#include "common/case/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "common/case/document.hpp"
#include "common/case/echo.hpp"
#include "common/case/nearest_name.hpp"
#include "common/case/value_reader.hpp"

namespace pennon {
namespace {

constexpr std::uintmax_t largest_case_file = 1 << 20;

// Walks a document along the schema.
class Walk {
 public:
  Walk(const Document& document, Schema& schema)
      : document_(document), schema_(schema), found_(document.refused_overrides) {}

  Faults read() {
    walk(document_.root, "");
    Faults faults(document_.name, places_, std::move(found_));
    for (const Table& table : schema_.tables) require(table, faults);
    return faults;
  }

 private:
  Table* table_named(const std::string& name) {
    const auto found = std::ranges::find(schema_.tables, name, &Table::name);
    return found == schema_.tables.end() ? nullptr : &*found;
  }

  void walk(const toml::table& node, const std::string& prefix) {
    Table* table = table_named(prefix);
    if (table != nullptr && table->is_given != nullptr) *table->is_given = true;
    for (const auto& [name, child] : node) {
      const std::string key(name.str());
      const std::string dotted = prefix.empty() ? echo(key) : prefix + "." + echo(key);
      const std::string place = document_.place(child);
      places_[dotted] = place;
      if (table != nullptr) {
        const auto declared = std::ranges::find(table->keys, key, &Key::name);
        if (declared != table->keys.end()) {
          for (std::string& what : read_value(*declared, child))
            found_.push_back({place, fmt::format("{} {}", dotted, what)});
          continue;
        }
      }
      if (is_table_or_above(dotted)) {
        if (const toml::table* inner = child.as_table())
          walk(*inner, dotted);
        else
          found_.push_back({place, fmt::format("{} must be a table, [{}], but is {} ({})", dotted,
                                               dotted, echo(child), kind_of(child))});
        continue;
      }
      found_.push_back({place, unknown(key, dotted, table, prefix, child.is_table())});
    }
  }

  bool is_table_or_above(const std::string& dotted) const {
    return std::ranges::any_of(schema_.tables, [&](const Table& table) {
      return table.name == dotted || table.name.starts_with(dotted + ".");
    });
  }

  std::string unknown(const std::string& key, const std::string& dotted, const Table* table,
                      const std::string& prefix, bool is_table) const {
    std::vector<std::string> known;
    if (table != nullptr)
      for (const Key& declared : table->keys)
        known.push_back(prefix.empty() ? declared.name : prefix + "." + declared.name);
    for (const Table& other : schema_.tables) {
      for (const Key& declared : other.keys)
        if (declared.name == key && other.name != prefix && !is_table)
          return fmt::format("{} is not a setting; did you mean {}.{}?", dotted, other.name, key);
      known.push_back(other.name);
    }
    return fmt::format("{} is not a {}{}", dotted, is_table ? "table of a case" : "setting",
                       did_you_mean(dotted, known));
  }

  void require(const Table& table, Faults& faults) const {
    const bool is_there = table.is_given == nullptr || *table.is_given;
    for (const Key& key : table.keys) {
      const std::string dotted = table.name + "." + key.name;
      if (key.is_required && is_there && !places_.contains(dotted))
        faults.about(table.name, fmt::format("{} is missing: {}; it must be {}", dotted, key.doc,
                                             key.range.text()));
    }
  }

  const Document& document_;
  Schema& schema_;
  std::map<std::string, std::string> places_;
  std::vector<InputFault> found_;
};

}  // namespace

void Faults::about(const std::string& key, std::string what) {
  const auto place = places_.find(key);
  faults_.push_back({place == places_.end() ? file_ : place->second, std::move(what)});
}

InputError Faults::located(const InputError& error) const {
  std::vector<InputFault> faults = error.faults();
  for (InputFault& fault : faults) {
    const std::size_t dot = fault.where.rfind('.');
    const auto place = places_.find(fault.where);
    const bool is_key = place != places_.end() || (dot != std::string::npos && dot > 0 &&
                                                   places_.contains(fault.where.substr(0, dot)));
    if (!is_key) continue;
    fault.what = fault.where + " " + fault.what;
    fault.where = place == places_.end() ? file_ : place->second;
  }
  return InputError(std::move(faults));
}

void Faults::raise() const {
  if (faults_.empty()) return;
  std::vector<InputFault> sorted = faults_;
  // First what is about the whole file, then its lines, then the overrides.
  const auto line = [this](const InputFault& fault) {
    if (fault.where == file_) return 0L;
    const bool is_line = fault.where.starts_with(file_ + ':');
    return is_line ? std::strtol(fault.where.c_str() + file_.size() + 1, nullptr, 10)
                   : std::numeric_limits<long>::max();
  };
  std::ranges::stable_sort(sorted, {}, line);
  throw InputError(std::move(sorted));
}

Faults read_case_text(std::string_view text, const std::string& name,
                      std::span<const std::string> overrides, Schema& schema) {
  Document document = parse_document(text, name);
  for (const std::string& assignment : overrides) apply_override(document, assignment);
  if (document.root.empty() && document.refused_overrides.empty())
    throw InputError(name, "is empty: a case needs at least [flag] with mu");
  return Walk(document, schema).read();
}

Faults read_case_file(const std::filesystem::path& file, std::span<const std::string> overrides,
                      Schema& schema) {
  namespace fs = std::filesystem;
  const std::string name = file.string();
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError(name, "there is no such file");
  if (!fs::status_known(status)) throw InputError(name, "cannot be read: " + error.message());
  if (fs::is_directory(status))
    throw InputError(
        name, "is a folder; a case is a TOML file, for example " + (file / "case.toml").string());
  if (!fs::is_regular_file(status)) throw InputError(name, "is not a regular file");
  if (const std::uintmax_t size = fs::file_size(file, error); size > largest_case_file)
    throw InputError(
        name, fmt::format("has {} bytes; a case file has at most {}", size, largest_case_file));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream || stream.bad())
    throw InputError(name, "cannot be read: " + std::generic_category().message(errno));
  return read_case_text(text.str(), name, overrides, schema);
}

}  // namespace pennon