// Whether the files that a result was made from are still the same.
#pragma once

#include "app/gui/workbench/outcome.h"

namespace remount::gui {

/// Hashes in the background what a calibration read, and compares it with what is on the disk when a project is opened.
/// The hashes are part of the outcome.
class InputFiles : public WorkbenchPart {
  Q_OBJECT
 public:
  InputFiles(const Desk& desk, Outcome& outcome) : WorkbenchPart(desk), outcome_(outcome) {}
  void hash();
  void compare();
  void stop();

 private:
  Outcome& outcome_;
  int job_ = 0;
};

}  // namespace remount::gui
