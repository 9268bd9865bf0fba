// The section through the selected pair, with the kinds of surfaces and the places that it can be laid through.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/pairs/section_plot.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace remount::widgets {

class SectionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SectionPanel(QWidget* parent = nullptr);
  quality::SectionKind kind() const;
  SectionPlot* plot() const { return plot_; }
  /// @param place its number among `places` that were found, from 0; nothing: one that the user chose
  void show_section(const quality::Section& section, std::vector<ShownCut> cuts, std::optional<std::size_t> place,
                    std::size_t places);
  void show_message(const QString& text);

 signals:
  void kind_chosen(quality::SectionKind kind);
  void next_clicked();
  void moved(const Eigen::Vector3d& by_m);

 private:
  QComboBox* kind_;
  QToolButton* next_;
  QLabel* place_;
  SectionPlot* plot_;
};

}  // namespace remount::widgets
