// Flows where links end: shares of turns, signals, who goes first, and who merges.
#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/cell_run.hpp"
#include "simulation/link_end.hpp"

namespace streetgen {

namespace {

bool yields_to(const TrafficNetwork& network, int link, int other) {
  for (const LinkConflict& c : network.conflicts.of(link))
    if (c.link == other) return c.precedence == Precedence::gives_way;
  return false;
}

// What a signal shows, and until when.
void look_at(CellRun& run, CellSignal& signal) {
  const TrafficNetwork& network = *run.network;
  const Aspect aspect = aspect_at(network, signal.link, run.time);
  run.closed[signal.link] = aspect == Aspect::red || aspect == Aspect::amber;
  const int number = network.links[signal.link].plan;
  signal.until = std::numeric_limits<double>::infinity();
  if (number < 0 || number >= static_cast<int>(network.plans.size())) return;
  const SignalPlan& plan = network.plans[number];
  double since = std::fmod(run.time - plan.start_offset, plan.cycle);
  if (since < 0) since += plan.cycle;
  double next = plan.cycle;
  for (const SignalAspect& a : network.aspects.of(signal.link))
    if (a.since > since) next = std::min<double>(next, a.since);
  signal.until = run.time + (next - since);
}

// A signal closes a movement, and those that go first leave a movement less than its capacity.
void limit_movements(CellRun& run) {
  for (CellSignal& signal : run.signalled)
    if (run.time >= signal.until) look_at(run, signal);
  for (const int link : run.yielding) {
    const double most = run.links[link].capacity;
    double left = most;
    double others = most;
    for (const LinkConflict& c : run.network->conflicts.of(link)) {
      if (begin_together(*run.network, link, c.link)) continue;
      const double flow = run.inflow[c.link].cars;
      if (c.precedence == Precedence::gives_way) left -= flow;
      if (c.precedence == Precedence::by_arrival)
        others = std::min(others, std::max(most / 2, most - flow));
    }
    run.limit[link] = std::max(0., std::min(left, others));
  }
}

// Who comes from outside takes what room is left.
void enter_flow(CellRun& run, int link, double room, double step) {
  const double outside = run.entry[link] + run.waiting[link] / step;
  const double entering = std::min(outside, room);
  run.inflow[link].cars += entering;
  run.inflow[link].eager += entering;
  run.waiting[link] = std::max(0., (outside - entering) * step);
  run.entered += entering * step;
}

template <class Law>
void join(CellRun& run, const Law& law, double step) {
  for (const CellJoint& j : run.joints) {
    const int last = run.last_cell(j.from);
    const LinkCells& to = run.links[j.to];
    const double eagerness = law.eagerness(run.states, last);
    const double room = law.taken(run.states, to.first, to, eagerness);
    const double flow = std::min(law.sent(run.states, last, run.links[j.from]), room);
    run.outflow[j.from] = run.inflow[j.to] = {flow, flow * eagerness};
    if (run.entry[j.to] > 0 || run.waiting[j.to] > 0) enter_flow(run, j.to, room - flow, step);
  }
}

template <class Law>
void send(CellRun& run, const Law& law) {
  for (const int link : run.senders)
    run.outflow[link].cars = law.sent(run.states, run.last_cell(link), run.links[link]);
}

// Each link takes what it can: first of those that go first, then of the others in proportion, and
// last of those that come from outside.
template <class Law>
void take(CellRun& run, const Law& law, double step) {
  const auto wanted = [&](const CellMerge& m) {
    return run.outflow[m.from].cars * run.share[m.row];
  };
  const double often = 1 / step;
  for (const int link : run.takers) {
    const auto merges = run.merges.of(link);
    const double outside = run.entry[link] + run.waiting[link] * often;
    double all = outside, eager = outside;
    for (const CellMerge& m : merges) {
      all += wanted(m);
      if (Law::carries) eager += wanted(m) * law.eagerness(run.states, run.last_cell(m.from));
    }
    double room = 0;
    if (all > 0 && !run.closed[link])
      room = std::min(run.limit[link], law.taken(run.states, run.links[link].first, run.links[link],
                                                 Law::carries ? eager / all : 1));
    for (int i = 0; i < merges.size();) {
      const int first = i;
      double rank = 0;
      for (; i < merges.size() && merges[i].after == merges[first].after; ++i)
        rank += wanted(merges[i]);
      const double part = rank > room ? room / rank : 1;
      for (int j = first; j < i; ++j) run.granted[merges[j].row] = part;
      room = std::max(0., room - rank * part);
    }
    run.inflow[link] = {};
    if (outside > 0) enter_flow(run, link, room, step);
  }
}

// Who goes on keeps the order of the link: the turn with the least room holds back all.
template <class Law>
void go_on(CellRun& run, const Law& law, double step) {
  const RowsOf<std::int32_t>& next = run.network->next;
  for (const int link : run.senders) {
    CellFlux& out = run.outflow[link];
    const double eagerness = law.eagerness(run.states, run.last_cell(link));
    double part = run.leaves[link] || next.starts[link] < next.starts[link + 1] ? 1 : 0;
    for (int row = next.starts[link]; row < next.starts[link + 1]; ++row)
      if (run.share[row] > 0) part = std::min(part, run.granted[row]);
    out.cars *= part;
    out.eager = out.cars * eagerness;
    for (int row = next.starts[link]; row < next.starts[link + 1]; ++row) {
      CellFlux& in = run.inflow[next.rows[row]];
      in.cars += out.cars * run.share[row];
      in.eager += out.eager * run.share[row];
    }
    if (run.leaves[link]) run.left += out.cars * step;
  }
}

}  // namespace

RowsOf<CellMerge> merges_of(const TrafficNetwork& network) {
  RowsOf<CellMerge> merges;
  for (int link = 0; link < network.size(); ++link) {
    const auto before = network.before.of(link);
    for (const int from : before) {
      CellMerge merge{-1, from, 0};
      for (int row = network.next.starts[from]; row < network.next.starts[from + 1]; ++row)
        if (network.next.rows[row] == link) merge.row = row;
      for (const int other : before) merge.after += yields_to(network, from, other);
      merges.add(merge);
    }
    std::stable_sort(merges.rows.end() - before.size(), merges.rows.end(),
                     [](const CellMerge& a, const CellMerge& b) { return a.after < b.after; });
    merges.end_owner();
  }
  return merges;
}

void find_joints(CellRun& run) {
  const TrafficNetwork& network = *run.network;
  std::vector<char> special(network.size(), 0);
  for (const CellSignal& signal : run.signalled) special[signal.link] = 1;
  for (const int link : run.yielding) special[link] = 1;
  const auto joint = [&](int from, int to) {
    return network.next.of(from).size() == 1 && network.before.of(to).size() == 1 && !special[to];
  };
  for (int link = 0; link < network.size(); ++link) {
    const auto next = network.next.of(link), before = network.before.of(link);
    if (!next.empty() && joint(link, next[0]))
      run.joints.push_back({link, next[0]});
    else
      run.senders.push_back(link);
    if (before.empty() || !joint(before[0], link)) run.takers.push_back(link);
  }
}

void flow_between_links(CellRun& run, double step) {
  run.by_law([&](const auto& law) {
    limit_movements(run);
    join(run, law, step);
    send(run, law);
    take(run, law, step);
    go_on(run, law, step);
  });
}

}  // namespace streetgen
