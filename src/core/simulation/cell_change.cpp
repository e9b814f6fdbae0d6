// Lane changes of a flow: to faster lanes, and from lanes that end.
#include <algorithm>

#include "simulation/cell_run.hpp"
#include "simulation/link_end.hpp"

namespace streetgen {

std::vector<CellChange> changes_of(const CellRun& run) {
  std::vector<CellChange> changes;
  for (int link = 0; link < run.network->size(); ++link) {
    const LinkCells& cells = run.links[link];
    const double length = run.network->links[link].length;
    const bool must = merges_beside(*run.network, link);
    for (const LinkBeside& b : run.network->beside.of(link)) {
      if (!b.may_change || b.opposite || b.from >= b.to) continue;
      if (merges_beside(*run.network, b.link)) continue;
      const LinkCells& others = run.links[b.link];
      for (int i = 0; i < cells.count; ++i) {
        const double middle = length * (i + 0.5) / cells.count;
        if (middle < b.from || middle > b.to) continue;
        const double share = (middle - b.from) / (b.to - b.from);
        const double there = b.other_from + share * (b.other_to - b.other_from);
        const int j = static_cast<int>(there / run.network->links[b.link].length * others.count);
        changes.push_back({cells.first + i, others.first + std::clamp(j, 0, others.count - 1), link,
                           b.link, must});
      }
    }
  }
  return changes;
}

void change_cells(CellRun& run, double step) {
  run.by_law([&](const auto& law) {
    for (const CellChange& c : run.changes) {
      const double here = run.states.density[c.from];
      if (here <= 0) continue;
      const LinkCells &link = run.links[c.link], &other = run.links[c.to_link];
      double wish = 1;
      if (!c.must) {
        const double mine = law.speed(run.states, c.from, link.speed);
        const double theirs = law.speed(run.states, c.to, other.speed);
        wish = std::max(0., theirs - mine) / std::max(link.speed, other.speed);
      }
      if (wish <= 0) continue;
      const double eagerness = law.eagerness(run.states, c.from);
      const double wanted = here * link.length * std::min(1., wish * step / run.rules.change_time);
      const double room = step * law.taken(run.states, c.to, other, eagerness);
      const double free = (run.rules.jam_density - run.states.density[c.to]) * other.length;
      const double cars = std::max(0., std::min({wanted, room, free}));
      run.states.density[c.from] -= cars / link.length;
      run.states.density[c.to] += cars / other.length;
      if (!run.states.eager.empty()) {
        run.states.eager[c.from] -= cars * eagerness / link.length;
        run.states.eager[c.to] += cars * eagerness / other.length;
      }
    }
  });
}

}  // namespace streetgen
