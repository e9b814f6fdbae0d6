// streetgen._link_towns, _link_crossings and _rank_size_towns: which towns there are and are
// linked.
#include "streetgen/road_network.hpp"

#include <string>
#include <vector>

#include "design/road_site.hpp"
#include "frame/argument.hpp"
#include "frame/geometry_result.hpp"
#include "value/number_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

// Kind, importance, x and y of each town.
std::vector<Town> towns_of(const NumberArray& array) {
  const std::vector<double> numbers = read_numbers(array, 4, "towns");
  std::vector<Town> towns;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    towns.push_back({static_cast<TownKind>(static_cast<int>(numbers[i])),
                     in_range(numbers[i + 1], 0, 1e10, "importance of a node"),
                     {numbers[i + 2], numbers[i + 3], 0}});
  return towns;
}

std::size_t town_number(double number, const std::vector<Town>& towns) {
  return static_cast<std::size_t>(
      in_range(number, 0, static_cast<double>(towns.size()) - 1, "number of a node"));
}

// Both towns, and the network.
std::vector<TownLink> links_of(const NumberArray& array, const std::vector<Town>& towns) {
  const std::vector<double> numbers = read_numbers(array, 3, "links");
  std::vector<TownLink> links;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    TownLink link;
    link.a = town_number(numbers[i], towns);
    link.b = town_number(numbers[i + 1], towns);
    link.network = static_cast<RoadNetwork>(static_cast<int>(numbers[i + 2]));
    link.by_hand = true;
    links.push_back(link);
  }
  return links;
}

void give_link(FunctionCallInfo fcinfo, const TownLink& link) {
  Datum values[8] = {Int32GetDatum(static_cast<int>(link.a)),
                     Int32GetDatum(static_cast<int>(link.b)),
                     Int32GetDatum(static_cast<int>(link.network)),
                     Float8GetDatum(link.length),
                     Float8GetDatum(link.utilisation),
                     Float8GetDatum(link.benefit),
                     Float8GetDatum(link.cost),
                     BoolGetDatum(link.by_hand)};
  bool nulls[8] = {false};
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_link_towns) {
  InitMaterializedSRF(fcinfo, 0);
  const NumberArray towns = take_numbers(fcinfo, 0), by_hand = take_numbers(fcinfo, 1),
                    rejected = take_numbers(fcinfo, 2);
  const double factor = PG_GETARG_FLOAT8(3);
  const bool shared = PG_GETARG_BOOL(4);
  using Links = std::vector<TownLink>;
  Slot<Links>* slot = make_slot<Links>(CurrentMemoryContext);
  report(compute([&] {
    NetworkWish wanted;
    const std::vector<Town> read = towns_of(towns);
    wanted.factor = in_range(factor, 0, 1e9, "factor");
    wanted.benefit = shared ? LinkBenefit::of_network : LinkBenefit::of_ends;
    wanted.by_hand = links_of(by_hand, read);
    const std::vector<double> pairs = read_numbers(rejected, 2, "rejected");
    for (std::size_t i = 0; i < pairs.size(); i += 2)
      wanted.rejected.emplace_back(town_number(pairs[i], read), town_number(pairs[i + 1], read));
    slot->value = new Links(link_towns(read, wanted));
  }));
  for (const TownLink& link : *slot->value) give_link(fcinfo, link);
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_link_crossings) {
  InitMaterializedSRF(fcinfo, 0);
  const NumberArray towns = take_numbers(fcinfo, 0), links = take_numbers(fcinfo, 1);
  using Crossings = std::vector<TownLinkCrossing>;
  Slot<Crossings>* slot = make_slot<Crossings>(CurrentMemoryContext);
  report(compute([&] {
    const std::vector<Town> read = towns_of(towns);
    slot->value = new Crossings(link_crossings(read, links_of(links, read)));
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const TownLinkCrossing& c : *slot->value) {
    Datum values[4] = {Float8GetDatum(c.point.x), Float8GetDatum(c.point.y),
                       Int32GetDatum(static_cast<int>(c.first)),
                       Int32GetDatum(static_cast<int>(c.second))};
    bool nulls[4] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_rank_size_towns) {
  InitMaterializedSRF(fcinfo, 0);
  const SiteArgument site = take_site(fcinfo, 0);
  const std::string_view area = take_bytes(fcinfo, 1);
  const NumberArray wishes = take_numbers(fcinfo, 2), there = take_numbers(fcinfo, 3);
  const int64 seed = PG_GETARG_INT64(4);
  using Towns = std::vector<Town>;
  Slot<Towns>* slot = make_slot<Towns>(CurrentMemoryContext);
  report(compute([&] {
    const std::vector<double> w = read_numbers(wishes, 7, "wishes");
    TownWish wish;
    wish.count = static_cast<int>(in_range(w.at(0), 1, 1000, "count"));
    wish.cities = static_cast<int>(in_range(w.at(1), 0, 1000, "cities"));
    wish.towns = static_cast<int>(in_range(w.at(2), 0, 1000, "towns"));
    wish.largest = in_range(w.at(3), 1, 1e10, "largest");
    wish.exponent = in_range(w.at(4), 0, 10, "exponent");
    wish.spacing = in_range(w.at(5), 0, 2, "spacing");
    wish.steepest = in_range(w.at(6), 0, 10, "steepest");
    wish.seed = static_cast<std::uint64_t>(seed);
    const auto read = read_site(site);
    slot->value = new Towns(rank_size_towns(read_surface(area, "area"), read->terrain, read->zones,
                                            wish, towns_of(there)));
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const Town& town : *slot->value) {
    Datum values[4] = {Int32GetDatum(static_cast<int>(town.kind)), Float8GetDatum(town.importance),
                       Float8GetDatum(town.point.x), Float8GetDatum(town.point.y)};
    bool nulls[4] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}
