#include "widgets/scene/mark_actor.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "widgets/scene/scene_stage.h"

namespace remount::scene {

struct MarkActor::Parts {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkActor2D> actor;
  vtkNew<vtkTextActor> text;
};

MarkActor::MarkActor(vtkRenderer& overlay) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  vtkNew<vtkCoordinate> in_world;
  in_world->SetCoordinateSystemToWorld();
  p.mapper->SetInputData(p.data);
  p.mapper->SetTransformCoordinate(in_world);
  p.actor->SetMapper(p.mapper);
  p.actor->GetProperty()->SetColor(0.80, 0.10, 0.50);
  p.actor->GetProperty()->SetPointSize(9.0F);
  p.actor->GetProperty()->SetLineWidth(2.0F);
  p.text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  p.text->SetTextScaleModeToNone();
  p.text->GetTextProperty()->SetFontSize(15);
  p.text->GetTextProperty()->BoldOn();
  p.text->GetTextProperty()->SetBackgroundOpacity(0.7);
  p.text->GetTextProperty()->SetLineOffset(-14.0);  // not on the mark itself
  overlay.AddViewProp(p.actor);
  overlay.AddViewProp(p.text);
  show({});
}

MarkActor::~MarkActor() = default;

void MarkActor::show(const SceneMarks& marks) {
  Parts& p = *parts_;
  const bool any = !marks.points_in_view.empty();
  p.actor->SetVisibility(any);
  p.text->SetVisibility(any && !marks.label.empty());
  if (!any) return;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices, lines;
  for (const Eigen::Vector3d& point : marks.points_in_view) {
    const vtkIdType id = points->InsertNextPoint(point.data());
    vertices->InsertNextCell(1, &id);
  }
  if (marks.points_in_view.size() == 2) {
    const vtkIdType ends[2] = {0, 1};
    lines->InsertNextCell(2, ends);
  }
  p.data->SetPoints(points);
  p.data->SetVerts(vertices);
  p.data->SetLines(lines);
  Eigen::Vector3d at = marks.points_in_view.back();
  if (marks.points_in_view.size() == 2) at = 0.5 * (marks.points_in_view[0] + marks.points_in_view[1]);
  p.text->SetInput(marks.label.c_str());
  p.text->GetPositionCoordinate()->SetValue(at.x(), at.y(), at.z());
}

void MarkActor::set_text_colors(const std::array<double, 3>& text, const std::array<double, 3>& background) {
  parts_->text->GetTextProperty()->SetColor(text[0], text[1], text[2]);
  parts_->text->GetTextProperty()->SetBackgroundColor(background[0], background[1], background[2]);
}

}  // namespace remount::scene
