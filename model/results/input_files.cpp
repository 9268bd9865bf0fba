#include "model/results/input_files.h"

#include <atomic>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "messages/stages.h"
#include "model/formats/files/sha256.h"

namespace remount::results {
namespace {

InputFile unhashed_input(const std::filesystem::path& path) {
  InputFile input;
  input.file = path.filename().string();
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  input.bytes = ignored ? 0 : size;
  return input;
}

void name_by_session(const drive::Session& session, const std::filesystem::path& file, InputFile& input) {
  input.session = session.name;
  const std::filesystem::path relative = file.lexically_relative(session.path);
  if (!relative.empty() && relative != "." && *relative.begin() != "..") input.file = relative.generic_string();
}

}  // namespace

InputFile hash_input(const std::filesystem::path& path) {
  InputFile input = unhashed_input(path);
  try {
    input.sha256 = formats::sha256_of_file(path);
  } catch (const Error&) {
    input.sha256.clear();
  }
  return input;
}

std::vector<InputFile> hash_inputs(const std::vector<std::shared_ptr<const drive::Session>>& sessions, int threads,
                                   Progress& progress) {
  std::vector<std::filesystem::path> files;
  std::map<std::filesystem::path, std::size_t> places;
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files)
      if (places.emplace(file, files.size()).second) files.push_back(file);
  std::vector<InputFile> hashed(files.size());
  std::atomic<std::size_t> done{0};
  parallel_for(files.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    hashed[i] = hash_input(files[i]);
    progress.report(say::stage_hashing_inputs, ++done, files.size());
  });
  std::vector<InputFile> inputs;
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) {
      inputs.push_back(hashed[places.at(file)]);
      name_by_session(*session, file, inputs.back());
    }
  return inputs;
}

std::vector<InputFile> list_inputs(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  std::vector<InputFile> inputs;
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) {
      inputs.push_back(unhashed_input(file));
      name_by_session(*session, file, inputs.back());
    }
  return inputs;
}

std::string changed_file(const std::vector<InputFile>& then, const std::vector<InputFile>& now) {
  // Two sessions of one name may have files of one name.
  std::multiset<std::tuple<std::string, std::string, std::uint64_t, std::string>> left;
  for (const InputFile& file : now) left.emplace(file.session, file.file, file.bytes, file.sha256);
  for (const InputFile& file : then) {
    const auto found = left.find({file.session, file.file, file.bytes, file.sha256});
    if (found == left.end()) return file.session + "/" + file.file;
    left.erase(found);
  }
  return {};
}

}  // namespace remount::results
