#include "streetgen/measure_text.hpp"

#include <string>

namespace streetgen {
namespace {

using Reader = std::optional<double> (*)(std::string_view, std::string_view);

struct Text {
  const char* text;
  double number;
};

void expect_read(Reader read, const char* unit, const std::vector<Text>& texts) {
  for (const Text& text : texts) {
    const auto number = read(text.text, unit);
    ASSERT_TRUE(number) << text.text;
    EXPECT_NEAR(*number, text.number, 1e-9) << text.text;
  }
}

void expect_unread(Reader read, const char* unit, const std::vector<const char*>& texts) {
  for (const char* text : texts) EXPECT_FALSE(read(text, unit)) << text;
}

TEST(ReadMetres, ReadsNumbersWithPointOrComma) {
  expect_read(read_metres, "m",
              {{"7", 7},
               {"3,5", 3.5},
               {" 7.25 ", 7.25},
               {".5", 0.5},
               {"5.", 5},
               {"+6", 6},
               {"-4", -4},
               {"1e-05", 1e-5},
               {"1e+15", 1e15}});
}

TEST(ReadMetres, ReadsUnits) {
  expect_read(read_metres, "m",
              {{"3,5 m", 3.5},
               {"7.0m", 7},
               {"3.5 M", 3.5},
               {"6.5 metres", 6.5},
               {"6 m.", 6},
               {"4 m\u00e8tres", 4},
               {"6\u00a0m", 6},
               {"350 cm", 3.5},
               {"10 feet", 3.048},
               {"12 ft", 3.6576},
               {"12ft.", 3.6576},
               {"22 yd", 20.1168},
               {"60 in", 1.524}});
}

TEST(ReadMetres, ReadsFeetAndInches) {
  expect_read(read_metres, "m",
              {{"16'", 4.8768},
               {"12'6\"", 3.81},
               {"12' 6\"", 3.81},
               {"12'6", 3.81},
               {"12'-6\"", 3.81},
               {"12\u2032 6\u2033", 3.81},
               {"12 ft 6 in", 3.81},
               {"12'6''", 3.81}});
  expect_unread(read_metres, "m", {"12'13\"", "12 ft 6", "6\"12'"});
}

TEST(ReadMetres, TakesTheMiddleOfSeveralLengths) {
  expect_read(read_metres, "m",
              {{"5-6", 5.5},
               {"5 \u2013 6 m", 5.5},
               {"5m;6m", 5.5},
               {"5 to 6", 5.5},
               {"10-20 ft", 4.572},
               {"5'-6'", 1.6764},
               {"7;5;6", 6}});
  expect_unread(read_metres, "m", {"5-", "5--6", ";6", "5-m"});
}

TEST(ReadMetres, ReadsAboutSoMuch) {
  expect_read(read_metres, "m", {{"~6", 6}, {"~ 6 m", 6}, {"ca. 6", 6}, {"about 6", 6}});
}

TEST(ReadMetres, GivesTextsWithoutAUnitTheirColumns) {
  expect_read(read_metres, "ft", {{"34", 10.3632}, {"34 ft", 10.3632}, {"7 m", 7}});
  expect_read(read_metres, "us-ft", {{"3937", 1200}});
  expect_unread(read_metres, "mph", {"34", "34 m"});
}

TEST(ReadMetres, ReadsNothingElse) {
  expect_unread(read_metres, "m", {"",    " ",   "abc",    "narrow",   "1.234,5",  "1,2,3",  ".",
                                   "nan", "inf", "1e999",  "6 m wide", "mm",       "6 mm m", "< 3",
                                   "5e",  "~",   "30 mph", "2 lanes",  "\xff\xfe", "'",      "to"});
  EXPECT_FALSE(read_metres(std::string(10000, '7'), "m"));
}

TEST(ReadKmh, ReadsUnits) {
  expect_read(read_kmh, "km/h",
              {{"50", 50},
               {"80.0", 80},
               {"60 km/h", 60},
               {"30 mph", 48.28032},
               {"20mph", 32.18688},
               {"20 knots", 37.04},
               {"10 kn", 18.52},
               {"5 m/s", 18},
               {"walk", 7},
               {"37,5", 37.5}});
  expect_read(read_kmh, "mph", {{"30", 48.28032}, {"50 km/h", 50}});
}

TEST(ReadKmh, ReadsZonesOfCountries) {
  expect_read(read_kmh, "km/h",
              {{"FR:urban", 50},
               {"DE:urban", 50},
               {"RU:urban", 60},
               {"DE:rural", 100},
               {"BE-VLG:rural", 70},
               {"DE:zone30", 30},
               {"DE:zone:30", 30},
               {"FR:zone20", 20},
               {"DE:30", 30},
               {"zone30", 30},
               {"DE:living_street", 7},
               {"FR:living_street", 20},
               {"GB:nsl_single", 96.56064},
               {"GB:motorway", 112.65408},
               {"GB:zone20", 32.18688},
               {"GB:20 mph", 32.18688},
               {"PL:motorway", 140}});
  expect_unread(read_kmh, "km/h",
                {"XX:urban", "DE:", "DE:zone", "DE:nowhere", ":30:", "FR:nsl_single"});
}

TEST(ReadKmh, TakesTheHighestOfAList) {
  expect_read(read_kmh, "km/h",
              {{"30;50", 50},
               {"50;30", 50},
               {"50|30", 50},
               {"100||", 100},
               {"|80|", 80},
               {"20;30 mph", 48.28032},
               {"DE:urban;100", 100}});
  expect_unread(read_kmh, "km/h", {"30;", ";30", "|", "||", "50;none", "30 50"});
}

TEST(ReadKmh, ReadsNothingElse) {
  expect_unread(
      read_kmh, "km/h",
      {"", "none", "signals", "variable", "-30", "50 m", "fast", "50 @ (wet)", "walking", "nan"});
}

}  // namespace
}  // namespace streetgen
