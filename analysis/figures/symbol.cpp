#include "analysis/figures/symbol.hpp"

#include <algorithm>
#include <cstddef>

namespace pennon::analysis {
namespace {

// ASCII letters, and the bytes of every letter beyond them in UTF-8.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// In UTF-8: a byte that continues a character begins with the bits 10.
std::ptrdiff_t characters(std::string_view text) {
  return std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });
}

class SymbolReader {
 public:
  explicit SymbolReader(std::string_view symbol) : rest_(symbol) {}

  std::string text() {
    while (!rest_.empty()) {
      if (is_letter(rest_.front()))
        add_product();
      else if (take('^'))
        add_attached('^', take_while([](char c) {
                       return is_letter(c) || is_digit(c) || c == '+' || c == '-';
                     }));
      else
        text_ += printed(take_first());
    }
    return text_;
  }

 private:
  static std::string printed(char c) { return c == '-' ? "−" : std::string(1, c); }
  static std::string printed(std::string_view part) {
    std::string result;
    for (const char c : part) result += printed(c);
    return result;
  }

  char take_first() {
    const char first = rest_.front();
    rest_.remove_prefix(1);
    return first;
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  template <class Predicate>
  std::string_view take_while(const Predicate& belongs) {
    std::size_t length = 0;
    while (length < rest_.size() && belongs(rest_[length])) ++length;
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }

  // Variables with their indices of one letter, and the spaces between them. A longer index ends
  // the product, since it is upright.
  void add_product() {
    std::string italic, word;
    bool continues = true;
    while (continues) {
      italic += take_while(is_letter);
      if (take('_')) {
        const std::string_view index =
            take_while([](char c) { return is_letter(c) || is_digit(c); });
        if (characters(index) > 1)
          word = index;
        else
          (italic += '_') += index;
      }
      continues = word.empty() && rest_.size() > 1 && rest_[0] == ' ' && is_letter(rest_[1]);
      if (continues) italic += take_first();
    }
    text_ += "{/:Italic " + italic + '}';
    if (!word.empty()) add_attached('_', word);
  }

  // An index or exponent; gnuplot needs braces around more than one character.
  void add_attached(char mark, std::string_view what) {
    text_ += mark;
    text_ += what.size() == 1 ? printed(what) : '{' + printed(what) + '}';
  }

  std::string_view rest_;
  std::string text_;
};

}  // namespace

std::string symbol_text(std::string_view symbol) {
  return SymbolReader(symbol).text();
}

std::string label_of(const hdf5::Reader& file, const std::string& array) {
  if (std::string label = file.text(array, "label"); !label.empty()) return label;
  const std::string quantity = file.text(array, "quantity");
  return (quantity.empty() ? "" : quantity + ' ') + symbol_text(file.text(array, "symbol"));
}

}  // namespace pennon::analysis
