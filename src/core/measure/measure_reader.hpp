// A text of measures, read from left to right.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace streetgen {

// A number of units; the unit is that of a later quantity where the text gives none.
struct Quantity {
  double number = 0;
  std::optional<double> unit{};
};

// What is taken is behind the reader; what is not there is not taken, and nothing moves.
class MeasureReader {
 public:
  // Small letters, plain spaces, quotation marks and hyphens stand for all of their kinds.  A text
  // of more than 200 bytes is read as one that means nothing.
  explicit MeasureReader(std::string_view text);

  bool at_end() const { return at_ == text_.size(); }
  bool take(std::string_view mark);
  // A word that ends where no letter follows.
  bool take_word(std::string_view word);
  // The letters of a unit, or its mark; a full stop may follow.
  std::string take_unit();
  std::optional<double> take_number();
  std::size_t place() const { return at_; }
  void back_to(std::size_t place) { at_ = place; }
  std::string_view rest() const { return std::string_view(text_).substr(at_); }

 private:
  void skip_spaces();

  std::string text_;
  std::size_t at_ = 0;
};

struct UnitName {
  std::string_view name;
  double size;
};

// The size of a unit by its name; nothing for a name that is none of them.
template <std::size_t count>
std::optional<double> size_of(const UnitName (&units)[count], std::string_view name) {
  for (const UnitName& unit : units)
    if (unit.name == name) return unit.size;
  return std::nullopt;
}

// The quantities in one size: those without a unit have that of the next one, the last `unit`.
std::vector<double> in_units(const std::vector<Quantity>& quantities, double unit);

}  // namespace streetgen
