#include "measure/measure_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace streetgen {

namespace {

struct Spelling {
  std::string_view written, meant;
};

// Longer spellings before those that they begin with.
constexpr Spelling spellings[] = {
    {"\u00a0", " "}, {"\u2009", " "},  {"\u202f", " "},  {"\t", " "},     {"\n", " "},
    {"\r", " "},     {"''", "\""},     {"\u2032", "'"},  {"\u2019", "'"}, {"\u00b4", "'"},
    {"`", "'"},      {"\u2033", "\""}, {"\u201d", "\""}, {"\u2010", "-"}, {"\u2011", "-"},
    {"\u2013", "-"}, {"\u2014", "-"},  {"\u2212", "-"},  {"\u2248", "~"}, {"\u00e8", "e"},
    {"\u00c8", "e"}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

std::string plain(std::string_view text) {
  std::string said;
  while (!text.empty()) {
    const auto found =
        std::find_if(std::begin(spellings), std::end(spellings), [&](const Spelling& spelling) {
          return text.substr(0, spelling.written.size()) == spelling.written;
        });
    if (found != std::end(spellings)) {
      said += found->meant;
      text.remove_prefix(found->written.size());
      continue;
    }
    const char c = text.front();
    said += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    text.remove_prefix(1);
  }
  return said;
}

}  // namespace

MeasureReader::MeasureReader(std::string_view text)
    : text_(text.size() <= 200 ? plain(text) : "?") {
  skip_spaces();
}

void MeasureReader::skip_spaces() {
  while (!at_end() && text_[at_] == ' ') ++at_;
}

bool MeasureReader::take(std::string_view mark) {
  if (rest().substr(0, mark.size()) != mark) return false;
  at_ += mark.size();
  skip_spaces();
  return true;
}

bool MeasureReader::take_word(std::string_view word) {
  const std::string_view behind = rest().substr(std::min(word.size(), rest().size()));
  return (behind.empty() || !is_letter(behind.front())) && take(word);
}

std::string MeasureReader::take_unit() {
  std::string unit;
  if (take("'")) return "'";
  if (take("\"")) return "\"";
  const auto goes_on = [&](std::size_t i) {
    return i < text_.size() && (is_letter(text_[i]) || text_[i] == '/');
  };
  while (goes_on(at_) || (!unit.empty() && !at_end() && text_[at_] == '-' && goes_on(at_ + 1)))
    unit += text_[at_++];
  if (!unit.empty()) take(".");
  skip_spaces();
  return unit;
}

std::optional<double> MeasureReader::take_number() {
  std::size_t end = at_;
  std::string digits;
  const auto take_digits = [&] {
    const std::size_t before = end;
    while (end < text_.size() && is_digit(text_[end])) digits += text_[end++];
    return end > before;
  };
  if (end < text_.size() && (text_[end] == '+' || text_[end] == '-'))
    if (text_[end++] == '-') digits = "-";
  bool any = take_digits();
  if (end < text_.size() && (text_[end] == '.' || text_[end] == ',')) {
    digits += '.';
    ++end;
    any = take_digits() || any;
  }
  if (!any) return std::nullopt;
  // Databases write the smallest and the greatest numbers as 1e-05 and 1e+15.
  if (end + 2 < text_.size() && text_[end] == 'e' &&
      (text_[end + 1] == '-' || text_[end + 1] == '+') && is_digit(text_[end + 2])) {
    digits += 'e';
    if (text_[++end] == '-') digits += '-';
    ++end;
    take_digits();
  }
  double number = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || !std::isfinite(number))
    return std::nullopt;
  at_ = end;
  skip_spaces();
  return number;
}

std::vector<double> in_units(const std::vector<Quantity>& quantities, double unit) {
  std::vector<double> sizes;
  for (auto quantity = quantities.rbegin(); quantity != quantities.rend(); ++quantity) {
    unit = quantity->unit.value_or(unit);
    sizes.push_back(quantity->number * unit);
  }
  return sizes;
}

}  // namespace streetgen
