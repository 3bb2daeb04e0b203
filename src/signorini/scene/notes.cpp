#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

const std::string note_mark = ". Note: ";  // between a message and its notes

}  // namespace

std::string with_notes(const std::string& message, const std::vector<std::string>& notes) {
  std::string all = message;
  for (const std::string& note : notes)
    if (message.find(note) == std::string::npos)
      all += (all.find(note_mark) == std::string::npos ? note_mark : "; ") + note;
  return all;
}

std::string without_notes(const std::string& message) {
  return message.substr(0, message.find(note_mark));
}

}  // namespace signorini
