#include "common/case/value_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/case/echo.hpp"
#include "common/case/nearest_name.hpp"

namespace pennon {
namespace {

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
  void read_into(std::optional<std::int64_t>* target) {
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
      if (node != nullptr) {
        const std::size_t before = faults_.size();
        const auto value = read_one(*node);
        for (std::size_t k = before; k < faults_.size(); ++k)
          faults_[k] = fmt::format("has a range whose {} {}", name, faults_[k]);
        return value;
      }
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

}  // namespace

std::vector<std::string> read_value(const Key& key, const toml::node& node) {
  return ValueReader(key, node).read();
}

}  // namespace pennon
