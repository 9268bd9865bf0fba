#include "model/formats/files/system_words.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "messages/system.h"

namespace remount::formats {

Message system_words(int number) {
  switch (number) {
    case ENOENT:
      return say::system_enoent();
    case EACCES:
      return say::system_eacces();
    case EPERM:
      return say::system_eperm();
    case ENOSPC:
      return say::system_enospc();
    case EDQUOT:
      return say::system_edquot();
    case EIO:
      return say::system_eio();
    case EROFS:
      return say::system_erofs();
    case EISDIR:
      return say::system_eisdir();
    case ENOTDIR:
      return say::system_enotdir();
    case ENAMETOOLONG:
      return say::system_enametoolong();
    case ESTALE:
      return say::system_estale();
    case ELOOP:
      return say::system_eloop();
    case EMFILE:
      return say::system_emfile();
    case EFBIG:
      return say::system_efbig();
    case ENOMEM:
      return say::system_enomem();
    case EBUSY:
      return say::system_ebusy();
    default:
      return Message::verbatim(std::strerror(number));
  }
}

Message system_words(const std::error_code& problem) {
  const bool is_errno = problem.category() == std::generic_category() || problem.category() == std::system_category();
  return is_errno ? system_words(problem.value()) : Message::verbatim(problem.message());
}

Message library_words(std::string_view words) {
  struct Known {
    std::string_view words;  // as the library has them
    Message (*message)();
  };
  constexpr Known kKnown[] = {
      {"database disk image is malformed", say::library_database_disk_image_is_malformed},
      {"file is not a database", say::library_file_is_not_a_database},
      {"database is locked", say::library_database_is_locked},
      {"unable to open database file", say::library_unable_to_open_database_file},
      {"disk I/O error", say::library_disk_i_o_error},
      {"out of memory", say::library_out_of_memory},
      {"illegal map value", say::library_illegal_map_value},
      {"illegal map key", say::library_illegal_map_key},
      {"end of map not found", say::library_end_of_map_not_found},
      {"end of map flow not found", say::library_end_of_map_flow_not_found},
      {"end of sequence not found", say::library_end_of_sequence_not_found},
      {"end of sequence flow not found", say::library_end_of_sequence_flow_not_found},
      {"illegal flow end", say::library_illegal_flow_end},
      {"illegal block entry", say::library_illegal_block_entry},
      {"illegal EOF in scalar", say::library_illegal_eof_in_scalar},
      {"illegal tab when looking for indentation", say::library_illegal_tab_when_looking_for_indentation},
      {"unknown token", say::library_unknown_token}};
  for (const Known& known : kKnown)
    if (known.words == words) return known.message();
  return Message::verbatim(std::string(words));
}

}  // namespace remount::formats
