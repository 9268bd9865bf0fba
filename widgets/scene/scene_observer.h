// A function that is called on an event of a VTK object, for as long as this lives.
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

#include <functional>

namespace remount::scene {

class SceneObserver {
 public:
  SceneObserver(vtkObject& object, unsigned long event, std::function<void()> act)
      : object_(&object), act_(std::move(act)) {
    command_->SetClientData(this);
    command_->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<SceneObserver*>(self)->act_(); });
    tag_ = object.AddObserver(event, command_);
  }
  ~SceneObserver() {
    if (object_) object_->RemoveObserver(tag_);
  }
  SceneObserver(const SceneObserver&) = delete;
  SceneObserver& operator=(const SceneObserver&) = delete;

 private:
  vtkWeakPointer<vtkObject> object_;
  std::function<void()> act_;
  vtkNew<vtkCallbackCommand> command_;
  unsigned long tag_ = 0;
};

}  // namespace remount::scene
