// For the law about names of types: never compiled.
#pragma once

namespace remount {

class Declared;

enum class Term { Linear, Angular };

struct Term::Inner {
  struct Nested {};
};

namespace other {
struct Item {};
}  // namespace other

}  // namespace remount
