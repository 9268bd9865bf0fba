// Options of scan registration, common to every algorithm.
#pragma once

#include "algorithms/cloud/beam_nodes.h"
#include "algorithms/core/options.h"
#include "algorithms/registration/instruction_set.h"
#include "messages/options.h"

namespace remount::registration {

enum class RegistrationAlgorithm { PlaneToPlane, PclIcp, PclGicp, PclNdt };

struct RegistrationOptions {
  RegistrationAlgorithm algorithm = RegistrationAlgorithm::PlaneToPlane;
  double voxel_m = 0.25;
  double max_range_m = 80.0;
  double min_range_m = 1.5;
  double max_correspondence_m = 1.0;
  int max_iterations = 40;
  double min_overlap = 0.3;
  double max_rmse_m = 0.15;
  bool search_when_doubtful = true;
  /// An alignment that stays near its start may fit worse than one that moves away before others are looked for; false
  /// where the start may be a mere guess, and both scans see the same place from nearly the same point.
  bool near_is_a_sign = true;
  double search_reach_m = 7.0;
  double search_reach_deg = 45.0;
  cloud::BeamNodes beam_nodes;                         ///< how the result moves with errors there is told, too
  InstructionSet instructions = InstructionSet::Best;  ///< for tests; the results are the same

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"algorithm", "", say::option_registration_algorithm, say::option_registration_algorithm_help},
                   self.algorithm, {"plane-to-plane", "pcl-icp", "pcl-gicp", "pcl-ndt"});
    visitor({"voxel_m", "m", say::option_registration_voxel_m, say::option_registration_voxel_m_help, 0.02, 5.0},
            self.voxel_m);
    visitor({"max_range_m", "m", say::option_registration_max_range_m, say::option_registration_max_range_m_help, 1.0,
             1000.0},
            self.max_range_m);
    visitor({"min_range_m", "m", say::option_registration_min_range_m, say::option_registration_min_range_m_help, 0.0,
             50.0},
            self.min_range_m);
    visitor({"max_correspondence_m", "m", say::option_registration_max_correspondence_m,
             say::option_registration_max_correspondence_m_help, 0.05, 20.0},
            self.max_correspondence_m);
    visitor({"max_iterations", "", say::option_registration_max_iterations,
             say::option_registration_max_iterations_help, 1, 1000},
            self.max_iterations);
    visitor(
        {"min_overlap", "", say::option_registration_min_overlap, say::option_registration_min_overlap_help, 0.0, 1.0},
        self.min_overlap);
    visitor(
        {"max_rmse_m", "m", say::option_registration_max_rmse_m, say::option_registration_max_rmse_m_help, 0.0, 10.0},
        self.max_rmse_m);
    visitor({"search_when_doubtful", "", say::option_registration_search_when_doubtful,
             say::option_registration_search_when_doubtful_help},
            self.search_when_doubtful);
    visitor({"search_reach_m", "m", say::option_registration_search_reach_m,
             say::option_registration_search_reach_m_help, 1.0, 20.0},
            self.search_reach_m);
    visitor({"search_reach_deg", "deg", say::option_registration_search_reach_deg,
             say::option_registration_search_reach_deg_help, 5.0, 180.0},
            self.search_reach_deg);
  }
};

}  // namespace remount::registration
