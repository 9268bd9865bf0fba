#include "widgets/scene/cloud_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>

namespace remount::scene {
namespace {

constexpr std::size_t kFirstPiece = 16384, kLargestPiece = 262144;

vtkSmartPointer<vtkPolyData> piece_of(const LevelCloud& cloud, std::size_t begin, std::size_t end) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  // Not written to: the array only has no constant form.
  auto* const first = const_cast<float*>(cloud.points[begin].data());
  coordinates->SetVoidArray(first, static_cast<vtkIdType>(3 * (end - begin)), 1);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkTypeInt32Array> offsets, indices;
  offsets->InsertNextValue(0);
  offsets->InsertNextValue(static_cast<int>(end - begin));
  indices->SetNumberOfValues(static_cast<vtkIdType>(end - begin));
  std::iota(indices->GetPointer(0), indices->GetPointer(0) + (end - begin), 0);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, indices);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetBounds();  // computed here, and not when it is first drawn
  return data;
}

void set_matrix(vtkActor& actor, const RigidTransform& view_from_cloud) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, view_from_cloud.matrix()(row, column));
  actor.SetUserMatrix(matrix);
}

}  // namespace

std::shared_ptr<const CloudGeometry> make_geometry(LevelCloud cloud) {
  auto geometry = std::make_shared<CloudGeometry>();
  geometry->cloud = std::make_shared<const LevelCloud>(std::move(cloud));
  const std::size_t size = geometry->cloud->size();
  for (std::size_t begin = 0; begin < size;) {
    const std::size_t end = std::min(size, begin + std::clamp(begin / 4, kFirstPiece, kLargestPiece));
    geometry->pieces.push_back(piece_of(*geometry->cloud, begin, end));
    geometry->piece_end.push_back(end);
    begin = end;
  }
  return geometry;
}

struct CloudActor::Piece {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

CloudActor::CloudActor(vtkRenderer& renderer) : renderer_(renderer) {}

CloudActor::~CloudActor() {
  for (const auto& piece : pieces_) renderer_.RemoveActor(piece->actor);
}

void CloudActor::set_geometry(std::shared_ptr<const CloudGeometry> geometry) {
  for (const auto& piece : pieces_) renderer_.RemoveActor(piece->actor);
  pieces_.clear();
  colors_ = nullptr;
  geometry_ = std::move(geometry);
  if (!geometry_) return;
  for (const auto& data : geometry_->pieces) {
    auto piece = std::make_unique<Piece>();
    piece->data->ShallowCopy(data);  // colours are this actor's own
    piece->mapper->SetInputData(piece->data);
    piece->mapper->SetScalarModeToUsePointData();
    piece->mapper->SetColorModeToDirectScalars();
    piece->mapper->ScalarVisibilityOff();
    piece->actor->SetMapper(piece->mapper);
    piece->actor->GetProperty()->LightingOff();
    set_matrix(*piece->actor, view_from_cloud_);
    renderer_.AddActor(piece->actor);
    pieces_.push_back(std::move(piece));
  }
  set_color(color_);
  set_point_size(point_size_);
  show_all();
}

void CloudActor::place(const RigidTransform& view_from_cloud) {
  view_from_cloud_ = view_from_cloud;
  for (const auto& piece : pieces_) set_matrix(*piece->actor, view_from_cloud);
}

void CloudActor::set_color(SceneColor color) {
  color_ = color;
  for (const auto& piece : pieces_)
    piece->actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

void CloudActor::set_colors(std::shared_ptr<const std::vector<SceneColor>> colors) {
  if (colors && colors->size() != (geometry_ ? geometry_->size() : 0)) colors = nullptr;
  colors_ = std::move(colors);
  for (std::size_t i = 0; i < pieces_.size(); ++i) apply_colors(i);
}

void CloudActor::apply_colors(std::size_t i) {
  Piece& piece = *pieces_[i];
  piece.mapper->SetScalarVisibility(colors_ != nullptr);
  if (!colors_) return;
  const std::size_t begin = i == 0 ? 0 : geometry_->piece_end[i - 1], end = geometry_->piece_end[i];
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(3);
  auto* const first = const_cast<unsigned char*>((*colors_)[begin].data());
  values->SetVoidArray(first, static_cast<vtkIdType>(3 * (end - begin)), 1);
  piece.data->GetPointData()->SetScalars(values);
  piece.data->Modified();
  piece.mapper->Modified();
}

void CloudActor::set_point_size(float pixels) {
  point_size_ = pixels;
  for (const auto& piece : pieces_) piece->actor->GetProperty()->SetPointSize(pixels);
}

std::size_t CloudActor::show(std::size_t points, std::size_t first) {
  shown_pieces_ = first;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool visible = i >= first && (i == first || geometry_->piece_end[i] <= points);
    pieces_[i]->actor->SetVisibility(visible);
    if (visible) shown_pieces_ = i + 1;
  }
  return shown_pieces_ == 0 ? 0 : geometry_->piece_end[shown_pieces_ - 1];
}

}  // namespace remount::scene
