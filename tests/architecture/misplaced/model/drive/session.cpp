// A function that returns a type of its own, in the namespace of another folder.
namespace remount::results {

Session open_it() { return {}; }

}  // namespace remount::results
