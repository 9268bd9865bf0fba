// Marked points and the line between them, drawn over everything.
#pragma once

#include <array>
#include <memory>

class vtkRenderer;

namespace remount::scene {

struct SceneMarks;

class MarkActor {
 public:
  explicit MarkActor(vtkRenderer& overlay);
  ~MarkActor();
  MarkActor(const MarkActor&) = delete;
  MarkActor& operator=(const MarkActor&) = delete;

  void show(const SceneMarks& marks);
  void set_text_colors(const std::array<double, 3>& text, const std::array<double, 3>& background);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::scene
