// Whom words about access let drive.
#pragma once

#include <string>

namespace streetgen {

// Those who let most in come first.
enum class Access {
  all,
  strange,  // the word means nothing
  destination,
  customers,
  delivery,
  owners,
  carpool,
  bus,
  cycle,
  nobody
};

// Of one word, in any case.
Access access_of_word(const std::string& word);

// Of several words, parted by ;, the one that lets most in counts.
Access access_of(const std::string& said);

// As column access of an axis has it; empty: all may drive, ?: the word means nothing.
const char* access_name(Access access);

// Does it shut out the cars of others than its owners?
bool shuts_cars_out(Access access);
// Does it let in cars that end there, or have an errand, and no others?
bool lets_cars_end(Access access);
// Does it let through those whom it is about?
bool lets_in(Access access);

}  // namespace streetgen
