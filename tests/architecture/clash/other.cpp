// For the law about names of types: never compiled.
namespace remount {

class Candidate final : public Other {
  double sum_ = 0.0;
};

}  // namespace remount
