// # Notes that outlive an error
//
// A plan collects notes: an element locks, two sides overlap, a choice has no meaning. They
// are printed with the plan. If the scene is refused before that, nobody would see them, and
// a note is often the cause of the error. So an error message carries them, in the form
// `MESSAGE. Note: FIRST NOTE; SECOND NOTE`.

#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

const std::string note_mark = ". Note: ";  // between a message and its notes

}  // namespace

// Errors pass several places that add notes. A note that stands in the message already is
// not added again. The mark comes before the first note only. Of many notes the first three are told, and
// how many more there are: a pile of discs has one for each pair, and the message would be lost among them.
std::string with_notes(const std::string& message, const std::vector<std::string>& notes) {
  std::string all = message;
  int left = 3;
  if (message.size() > 5 && message.compare(message.size() - 5, 5, " more") == 0) return message;  // was cut before
  for (const std::string& note : notes)
    if (all.find(note) == std::string::npos && left-- > 0)
      all += (all.find(note_mark) == std::string::npos ? note_mark : "; ") + note;
  return left >= 0 ? all : all + "; and " + std::to_string(-left) + " more";
}

// Two errors may have the same cause and different notes. The reader of scene files compares
// errors, so it takes the notes off.
std::string without_notes(const std::string& message) {
  return message.substr(0, message.find(note_mark));
}

}  // namespace signorini
