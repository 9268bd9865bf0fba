// Options of scan registration, common to every algorithm.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/registration/instruction_set.h"

namespace remount {

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
  InstructionSet instructions = InstructionSet::Best;  ///< for tests; the results are the same

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"algorithm", "",
                    "How two scans are aligned: own plane-to-plane engine, or PCL's. With pcl-icp and pcl-ndt errors "
                    "may be several times the sigma that is stated: for comparison only."},
                   self.algorithm, {"plane-to-plane", "pcl-icp", "pcl-gicp", "pcl-ndt"});
    visitor({"voxel_m", "m", "Edge of the voxels that thin a scan before alignment.", 0.02, 5.0}, self.voxel_m);
    visitor({"max_range_m", "m", "Points farther than this from the sensor are left out.", 1.0, 1000.0},
            self.max_range_m);
    visitor({"min_range_m", "m", "Points nearer than this to the sensor (the vehicle itself) are left out.", 0.0, 50.0},
            self.min_range_m);
    visitor({"max_correspondence_m", "m", "Neighbours farther apart than this do not count in the last iterations.",
             0.05, 20.0},
            self.max_correspondence_m);
    visitor({"max_iterations", "", "Iterations before an alignment is given up.", 1, 1000}, self.max_iterations);
    visitor({"min_overlap", "", "An alignment with a smaller share of inliers is rejected.", 0.0, 1.0},
            self.min_overlap);
    visitor({"max_rmse_m", "m", "An alignment with larger inlier residuals is rejected.", 0.0, 10.0}, self.max_rmse_m);
    visitor({"search_when_doubtful", "",
             "Where an alignment fails, fits upright surfaces badly or moved far, others around its start are tried."},
            self.search_when_doubtful);
    visitor({"search_reach_m", "m", "How far around the start other positions are tried.", 1.0, 20.0},
            self.search_reach_m);
    visitor({"search_reach_deg", "deg", "How far around the start other yaws are tried.", 5.0, 180.0},
            self.search_reach_deg);
  }
};

}  // namespace remount
