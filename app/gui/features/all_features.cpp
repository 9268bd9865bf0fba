#include "app/gui/features/all_features.h"

#include "app/gui/features/candidates_feature.h"
#include "app/gui/features/contact_sheet_feature.h"
#include "app/gui/features/drive_feature.h"
#include "app/gui/features/help_feature.h"
#include "app/gui/features/import_feature.h"
#include "app/gui/features/log_feature.h"
#include "app/gui/features/map_feature.h"
#include "app/gui/features/methods_feature.h"
#include "app/gui/features/pair_view_feature.h"
#include "app/gui/features/pairs_feature.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/features/quality_feature.h"
#include "app/gui/features/residuals_feature.h"
#include "app/gui/features/result_feature.h"
#include "app/gui/features/run_feature.h"
#include "app/gui/features/section_feature.h"
#include "app/gui/features/setup_feature.h"
#include "app/gui/features/vehicle_feature.h"

namespace remount::gui {

std::vector<MakeFeature> all_features() {
  return {
      plug<RunFeature>(),           //
      plug<ProjectFeature>(),       //
      plug<ImportFeature>(),        //
      plug<SetupFeature>(),         //
      plug<ResultFeature>(),        //
      plug<PairsFeature>(),         //
      plug<SectionFeature>(),       //
      plug<ResidualsFeature>(),     //
      plug<PairViewFeature>(),      //
      plug<ContactSheetFeature>(),  //
      plug<DriveFeature>(),         //
      plug<CandidatesFeature>(),    //
      plug<MapFeature>(),           //
      plug<VehicleFeature>(),       //
      plug<QualityFeature>(),       //
      plug<MethodsFeature>(),       //
      plug<LogFeature>(),           //
      plug<HelpFeature>(),
  };
}

}  // namespace remount::gui
