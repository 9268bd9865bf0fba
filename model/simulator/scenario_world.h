// What stands along the road of each scenario.
#pragma once

#include "model/simulator/road.h"
#include "model/simulator/world.h"

namespace remount::simulator {

/// Street, hill and the like: see build_world. Highway: guard rails, posts, trees, noise barriers, gantries. Tunnel:
/// smooth walls and a ceiling over flat ground from the first portal to the second, and nothing on them but cabinets
/// near the portals; posts and boxes outside. Slew yard: see yard_world.
World build_scenario_world(const Road& road, const Ground& ground, const SimulationOptions& options);

/// Where the tunnel of such a drive begins and ends along the road, m.
struct TunnelReach {
  double from_m = 0.0, to_m = 0.0;
};
TunnelReach tunnel_reach(const SimulationOptions& options);

}  // namespace remount::simulator
