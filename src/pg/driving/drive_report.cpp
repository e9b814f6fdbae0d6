// streetgen._drive_report: a log of drives on a network.
#include "streetgen/drive_report.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/network_bytes.hpp"
#include "value/given_rows.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

struct LogCall {
  ValueArray actors, times, x, y, heights, speeds, lengths;
};

LogCall take_log(FunctionCallInfo fcinfo) {
  LogCall call;
  call.actors = take_values(fcinfo, 1, INT4OID, any_count, "actors");
  const auto numbers = [&](int argument, const char* name) {
    return take_values(fcinfo, argument, FLOAT8OID, call.actors.count, name);
  };
  call.times = numbers(2, "times");
  call.x = numbers(3, "x");
  call.y = numbers(4, "y");
  call.heights = numbers(5, "heights");
  call.speeds = numbers(6, "speeds");
  call.lengths = numbers(7, "lengths");
  return call;
}

std::vector<DriveSample> samples_of(const LogCall& call) {
  std::vector<DriveSample> samples;
  for (int i = 0; i < call.actors.count; ++i) {
    const auto number = [&](const ValueArray& values) { return DatumGetFloat8(values.values[i]); };
    DriveSample sample;
    sample.actor = DatumGetInt32(call.actors.values[i]);
    sample.time = number(call.times);
    sample.x = number(call.x);
    sample.y = number(call.y);
    sample.height = number(call.heights);
    sample.speed = number(call.speeds) * kmh;
    sample.length = static_cast<float>(in_range(number(call.lengths), 0.5, longest_car,
                                                "the length at sample " + std::to_string(i + 1)));
    samples.push_back(sample);
  }
  return samples;
}

struct ReportRow {
  DrivenSample driven;
  std::int64_t link_id = 0;
};

std::vector<ReportRow> report_rows(const TrafficNetwork& network, const LogCall& call) {
  std::vector<ReportRow> rows;
  for (const DrivenSample& driven : drive_report(network, samples_of(call))) {
    const int link = driven.located.place.link;
    rows.push_back({driven, link < 0 ? 0 : network.links[link].link_id});
  }
  return rows;
}

// The speed that a link allows is single, so that more would be noise.
double thousandths(double value) { return std::round(value * 1000) / 1000 + 0.0; }

const char* finding_word(DriveFinding finding) {
  switch (finding) {
    case DriveFinding::no_time:
      return "no_time";
    case DriveFinding::no_place:
      return "no_place";
    case DriveFinding::twice:
      return "twice";
    default:
      return "off_road";
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_drive_report) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const LogCall call = take_log(fcinfo);
  auto* slot = make_slot<std::vector<ReportRow>>(CurrentMemoryContext);
  report(compute(
      [&] { slot->value = new std::vector<ReportRow>(report_rows(read_network(bytes), call)); }));
  put_rows(fcinfo, *slot->value, [](const ReportRow& row, ReturnSetInfo* result) {
    const DrivenSample& d = row.driven;
    const bool nowhere = d.located.place.link < 0, alone = d.leader < 0;
    Datum values[] = {
        Int64GetDatum(row.link_id),
        Float8GetDatum(d.located.place.metres),
        Float8GetDatum(d.located.offset + 0.0),
        BoolGetDatum(d.against),
        Float8GetDatum(d.speed / kmh),
        Float8GetDatum(thousandths(d.over_limit / kmh)),
        Int32GetDatum(d.leader),
        Float8GetDatum(d.gap),
        Float8GetDatum(d.time_to_collision),
        d.finding == DriveFinding::none ? Datum{} : CStringGetTextDatum(finding_word(d.finding))};
    bool nulls[] = {nowhere,
                    nowhere,
                    nowhere,
                    nowhere,
                    !std::isfinite(d.speed),
                    !std::isfinite(d.over_limit),
                    alone,
                    alone,
                    !std::isfinite(d.time_to_collision),
                    d.finding == DriveFinding::none};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
