// A type in the namespace of another folder.
#pragma once

namespace remount::pipeline {
class Stage;
}  // namespace remount::pipeline

namespace remount::results {

struct Session {};

}  // namespace remount::results
