// Where dialogs for files begin.
#include "widgets/basics/file_dialogs.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace remount::widgets {
namespace {

TEST(file_dialogs, begin_where_files_of_their_kind_were_chosen_last) {
  const QTemporaryDir drives, pictures;
  remember_folder_of(drives.filePath("drive1"), FileKind::Recordings);
  remember_folder_of(pictures.filePath("view.png"), FileKind::Pictures);
  EXPECT_EQ(QDir(usual_folder(FileKind::Recordings)), QDir(drives.path()));
  EXPECT_EQ(QDir(usual_folder(FileKind::Pictures)), QDir(pictures.path()));
  remember_folder_of({}, FileKind::Pictures);  // cancelled
  EXPECT_EQ(QDir(usual_folder(FileKind::Pictures)), QDir(pictures.path()));
  remember_folder_of(drives.filePath("other.png"), FileKind::Pictures);
  EXPECT_EQ(QDir(usual_folder(FileKind::Pictures)), QDir(drives.path()));
}

TEST(file_dialogs, begin_anywhere_where_that_folder_is_gone) {
  QTemporaryDir gone;
  remember_folder_of(gone.filePath("report.html"), FileKind::Reports);
  ASSERT_TRUE(gone.remove());
  EXPECT_EQ(usual_folder(FileKind::Reports), QString());
}

}  // namespace
}  // namespace remount::widgets
