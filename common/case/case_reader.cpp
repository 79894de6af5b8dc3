#include "common/case/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "common/case/nearest_name.hpp"
#include "common/case/toml_depth.hpp"
#include "common/utf8.hpp"

namespace pennon {
namespace {

constexpr std::uintmax_t largest_case_file = 1 << 20;
constexpr std::size_t longest_echo = 60;
constexpr std::size_t most_name_parts = 16;  // far more than any case needs: lsa.map has two

// The text, cut between two letters where it is long.
std::string shortened(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size() && end < longest_echo)
    end += std::max<std::size_t>(utf8_length(std::string_view(text).substr(end)), 1);
  return end < text.size() ? text.substr(0, end) + "..." : text;
}

// The value as the user wrote it.
std::string echo(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  std::string shown = text.str();
  std::replace(shown.begin(), shown.end(), '\n', ' ');
  return shortened(shown);
}

// A name as the user wrote it: in quotes, with its control characters escaped, unless it is bare.
std::string echo(const std::string& name) {
  const auto is_bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (!name.empty() && std::ranges::all_of(name, is_bare)) return shortened(name);
  return echo(toml::value<std::string>(name));
}

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

// Reads the value of one key; each fault is a sentence without the key's name, which the caller
// knows.
class ValueReader {
 public:
  ValueReader(const Key& key, const toml::node& node) : key_(key), node_(node) {}

  std::vector<std::string> read() {
    std::visit([this](auto& target) { read_into(target); }, binding());
    return std::move(faults_);
  }

 private:
  // The key holds pointers to the case's variables: reading changes those, not the key.
  Binding& binding() const { return const_cast<Key&>(key_).value; }

  void expected(const std::string& right) {
    faults_.push_back(
        fmt::format("must be {}, but is {} ({})", right, echo(node_), kind_of(node_)));
  }

  std::optional<double> number(const toml::node& node, const Range& range) {
    const std::optional<double> value =
        node.is_number() ? node.value<double>() : std::optional<double>();
    if (!value || !std::isfinite(*value)) {
      faults_.push_back(fmt::format("must be a finite number {}, but is {}{}", range.text(),
                                    echo(node),
                                    node.is_number() ? "" : " (" + kind_of(node) + ")"));
      return std::nullopt;
    }
    if (!range.contains(*value)) {
      faults_.push_back(fmt::format("must be {}, but is {}", range.text(), echo(node)));
      return std::nullopt;
    }
    return value;
  }

  std::optional<std::int64_t> integer(const toml::node& node, const Range& range) {
    if (!node.is_integer()) {
      faults_.push_back(fmt::format("must be an integer {}, but is {} ({})", range.text(),
                                    echo(node), kind_of(node)));
      return std::nullopt;
    }
    if (!number(node, range)) return std::nullopt;
    return node.value<std::int64_t>();
  }

  std::optional<std::string> text(const toml::node& node) {
    auto value = node.value_exact<std::string>();
    if (!value) {
      faults_.push_back(
          fmt::format("must be a text in quotes, but is {} ({})", echo(node), kind_of(node)));
      return std::nullopt;
    }
    if (!key_.known.empty() && std::ranges::find(key_.known, *value) == key_.known.end()) {
      faults_.push_back(fmt::format("must be one of {}, but is {}{}", fmt::join(key_.known, ", "),
                                    echo(node), did_you_mean(*value, key_.known)));
      return std::nullopt;
    }
    return value;
  }

  void read_into(double* target) {
    if (const auto value = number(node_, key_.range)) *target = *value;
  }
  void read_into(std::optional<double>* target) {
    if (const auto value = number(node_, key_.range)) *target = *value;
  }
  void read_into(std::int64_t* target) {
    if (const auto value = integer(node_, key_.range)) *target = *value;
  }
  void read_into(bool* target) {
    if (const auto value = node_.value_exact<bool>())
      *target = *value;
    else
      expected("true or false");
  }
  void read_into(std::string* target) {
    if (const auto value = text(node_)) *target = *value;
  }

  // Reads each element of a list with `read_one`; nothing if any is at fault.
  template <class T, class ReadOne>
  std::optional<std::vector<T>> list(const std::string& right, ReadOne read_one) {
    const toml::array* array = node_.as_array();
    if (array == nullptr) {
      expected(right);
      return std::nullopt;
    }
    const std::size_t faults_before = faults_.size();
    std::vector<T> values;
    for (const toml::node& element : *array) {
      const std::optional<T> value = read_one(element);
      if (!value && faults_.size() > faults_before) return std::nullopt;
      if (value) values.push_back(*value);
    }
    return values;
  }
  std::optional<std::vector<double>> numbers(const std::string& right) {
    return list<double>(right, [this](const toml::node& n) { return number(n, key_.range); });
  }

  void read_into(std::array<double, 3>* target) {
    const auto values = numbers("a list of three numbers");
    if (!values) return;
    if (values->size() == 3)
      std::ranges::copy(*values, target->begin());
    else
      expected("a list of three numbers");
  }
  void read_into(std::vector<double>* target) {
    if (auto values = numbers("a list of numbers")) *target = std::move(*values);
  }
  void read_into(std::vector<std::int64_t>* target) {
    auto values = list<std::int64_t>(
        "a list of integers", [this](const toml::node& n) { return integer(n, key_.range); });
    if (values) *target = std::move(*values);
  }
  void read_into(std::vector<std::string>* target) {
    auto values =
        list<std::string>("a list of texts", [this](const toml::node& n) { return text(n); });
    if (values) *target = std::move(*values);
  }
  void read_into(Choice& target) {
    const auto value = node_.value_exact<std::string>();
    const auto found = value ? std::ranges::find(target.names, *value) : target.names.end();
    if (found == target.names.end()) {
      faults_.push_back(fmt::format("must be one of \"{}\", but is {}{}",
                                    fmt::join(target.names, "\", \""), echo(node_),
                                    value ? did_you_mean(*value, target.names) : std::string()));
      return;
    }
    target.choose(static_cast<std::size_t>(found - target.names.begin()));
  }

  void read_into(std::optional<Sweep>* target) {
    static const std::string form = "a range { from = a, to = b, points = n } or a list of numbers";
    if (node_.is_array()) {
      const auto values = numbers(form);
      if (!values) return;
      if (values->empty()) return expected("a list of at least one number");
      Sweep sweep;
      sweep.list = *values;
      *target = sweep;
      return;
    }
    if (const toml::table* table = node_.as_table())
      read_range(*table, target);
    else
      expected(form);
  }

  void read_range(const toml::table& table, std::optional<Sweep>* target) {
    static const std::vector<std::string> parts = {"from", "to", "points", "scale"};
    static constexpr Range point_count{2, 1e9};
    const std::size_t faults_before = faults_.size();
    Sweep sweep;
    for (const auto& [name, node] : table) {
      const std::string part(name.str());
      if (std::ranges::find(parts, part) == parts.end()) {
        faults_.push_back(
            fmt::format("has an unknown part {}{}; a range has from, to, points, scale", echo(part),
                        did_you_mean(part, parts)));
      }
    }
    const auto part = [&](const char* name, auto read_one) {
      const toml::node* node = table.get(name);
      if (node != nullptr) return read_one(*node);
      faults_.push_back(
          fmt::format("lacks {}: a range is {{ from = a, to = b, points = n }}", name));
      return decltype(read_one(table))();
    };
    const auto from = part("from", [&](const toml::node& n) { return number(n, key_.range); });
    const auto to = part("to", [&](const toml::node& n) { return number(n, key_.range); });
    const auto points =
        part("points", [&](const toml::node& n) { return integer(n, point_count); });
    if (const toml::node* scale = table.get("scale")) {
      const auto name = scale->value_exact<std::string>();
      if (name == "log")
        sweep.scale = Scale::log;
      else if (name != "linear")
        faults_.push_back(
            fmt::format("has the scale {}, which must be \"linear\" or \"log\"", echo(*scale)));
    }
    if (faults_.size() > faults_before || !from || !to || !points) return;
    sweep.from = *from;
    sweep.to = *to;
    sweep.points = *points;
    if (sweep.from >= sweep.to)
      faults_.push_back(fmt::format("must have from < to, but from = {} and to = {}", *from, *to));
    else if (sweep.scale == Scale::log && sweep.from <= 0)
      faults_.push_back(fmt::format("is logarithmic, so from must be > 0, but is {}", *from));
    else
      *target = sweep;
  }

  const Key& key_;
  const toml::node& node_;
  std::vector<std::string> faults_;
};

// A document of the case with the place of every key, overrides included.
struct Document {
  toml::table root;
  std::string name;
  std::map<const toml::node*, std::string> override_places = {};
  std::vector<InputFault> refused_overrides = {};

  std::string place(const toml::node& node) const {
    if (const auto found = override_places.find(&node); found != override_places.end())
      return found->second;
    return fmt::format("{}:{}", name, node.source().begin.line);
  }

  // Says that a node and all in it come from an override.
  void overridden(const toml::node& node, const std::string& where) {
    override_places[&node] = where;
    if (const toml::table* table = node.as_table())
      for (const auto& [key, child] : *table) overridden(child, where);
  }
};

toml::table parse(std::string_view text, const std::string& name) {
  if (text.find('\0') != std::string_view::npos)
    throw InputError(name,
                     "is not a case file: it holds binary data (a NUL byte); a case is TOML text");
  if (const DottedName deepest = deepest_name(text); deepest.parts > most_name_parts)
    throw InputError(fmt::format("{}:{}", name, deepest.line),
                     fmt::format("has a name of {} parts joined by dots; no name has more than {}",
                                 deepest.parts, most_name_parts));
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& fault) {
    throw InputError(fmt::format("{}:{}", name, fault.source().begin.line),
                     fmt::format("is not TOML: {} (column {})", fault.description(),
                                 fault.source().begin.column));
  }
}

std::vector<std::string> split(std::string_view dotted) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= dotted.size();) {
    const std::size_t dot = std::min(dotted.find('.', begin), dotted.size());
    parts.emplace_back(dotted.substr(begin, dot - begin));
    begin = dot + 1;
  }
  return parts;
}

// The value of an override: TOML where it parses as one value, else the text itself.
toml::table parse_value(const std::string& text) {
  try {
    if (deepest_name(text).parts <= most_name_parts) {
      toml::table parsed = toml::parse("value = " + text);
      if (parsed.size() == 1) return parsed;
    }
  } catch (const toml::parse_error&) {
    // not TOML: taken as text below
  }
  return toml::table{{"value", text}};
}

// The table an override's key is in, made where it is not there; null where a value is in its way.
toml::table* table_of(Document& document, std::span<const std::string> path,
                      const std::string& where) {
  toml::table* table = &document.root;
  for (const std::string& name : path) {
    toml::node* child = table->get(name);
    if (child == nullptr) {
      child = &table->insert_or_assign(name, toml::table{}).first->second;
      document.overridden(*child, where);
    }
    table = child->as_table();
    if (table == nullptr) return nullptr;
  }
  return table;
}

// Puts one --set table.key=value into the document.
void apply_override(Document& document, const std::string& assignment) {
  const std::string where = "--set " + shortened(assignment);
  const auto refuse = [&](std::string what) {
    document.refused_overrides.push_back({where, std::move(what)});
  };
  const std::size_t equals = assignment.find('=');
  const std::vector<std::string> path = split(assignment.substr(0, equals));
  const bool has_empty_part = std::ranges::any_of(path, &std::string::empty);
  if (!is_utf8(assignment)) return refuse("is not text in UTF-8");
  if (equals == std::string::npos || path.size() < 2 || path.size() > most_name_parts ||
      has_empty_part)
    return refuse("must have the form table.key=value, for example flag.mu=0.1");
  toml::table* table = table_of(document, std::span(path).first(path.size() - 1), where);
  if (table == nullptr)
    return refuse(fmt::format("a part of {} is a value and not a table, so it has no keys",
                              shortened(assignment.substr(0, assignment.rfind('.', equals)))));
  const toml::table parsed = parse_value(assignment.substr(equals + 1));
  const auto place = table->insert_or_assign(path.back(), *parsed.get("value")).first;
  document.overridden(place->second, where);
}

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
          for (std::string& what : ValueReader(*declared, child).read())
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
  Document document{parse(text, name), name};
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
