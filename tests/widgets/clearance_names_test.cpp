// The chooser of sessions on the page of clearances.
#include <gtest/gtest.h>

#include <QComboBox>

#include "widgets/quality/clearance_view.h"

namespace remount::widgets {
namespace {

TEST(clearance_view, shows_of_long_names_what_tells_them_apart) {
  ClearanceView view;
  const auto& chooser = *view.findChild<QComboBox*>();
  const auto shown = [&](const QStringList& names) {
    view.show_choices(names, std::vector<int>(static_cast<std::size_t>(names.size()), 3));
    QStringList texts;
    for (int i = 0; i < chooser.count(); ++i) {
      texts << chooser.itemText(i);
      EXPECT_EQ(chooser.itemData(i, Qt::ToolTipRole).toString(), names[i]);
    }
    return texts;
  };
  EXPECT_EQ(shown({"2011_09_30_drive_0000_sync", "2011_09_30_drive_0005_sync"}),
            (QStringList{"…0000_sync", "…0005_sync"}));
  EXPECT_EQ(shown({"2011_09_30_drive_0000_sync"}), QStringList{"2011_09_30_drive_0000_sync"});
  EXPECT_EQ(shown({"yard", "street"}), (QStringList{"yard", "street"}));
  EXPECT_EQ(shown({"morning drive", "morning drive"}), (QStringList{"morning drive", "morning drive"}));
}

}  // namespace
}  // namespace remount::widgets
