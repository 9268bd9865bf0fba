#include "app/gui/features/all_features.h"

#include "app/gui/features/candidates_feature.h"
#include "app/gui/features/drive_feature.h"
#include "app/gui/features/help_feature.h"
#include "app/gui/features/log_feature.h"
#include "app/gui/features/map_feature.h"
#include "app/gui/features/methods_feature.h"
#include "app/gui/features/pair_view_feature.h"
#include "app/gui/features/pairs_feature.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/features/quality_feature.h"
#include "app/gui/features/result_feature.h"
#include "app/gui/features/run_feature.h"
#include "app/gui/features/setup_feature.h"

namespace remount::gui {

std::vector<MakeFeature> all_features() {
  return {
      plugged<RunFeature>(),         //
      plugged<ProjectFeature>(),     //
      plugged<SetupFeature>(),       //
      plugged<ResultFeature>(),      //
      plugged<PairsFeature>(),       //
      plugged<PairViewFeature>(),    //
      plugged<DriveFeature>(),       //
      plugged<CandidatesFeature>(),  //
      plugged<MapFeature>(),         //
      plugged<QualityFeature>(),     //
      plugged<MethodsFeature>(),     //
      plugged<LogFeature>(),         //
      plugged<HelpFeature>(),
  };
}

}  // namespace remount::gui
