// For the law about names of types: never compiled.
namespace remount {
namespace {

struct Term {};

namespace within {
struct Item {};
}  // namespace within

}  // namespace

class Declared {
  struct Nested {};
};

struct Item {};

}  // namespace remount
