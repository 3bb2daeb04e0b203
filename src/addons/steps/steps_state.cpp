#include <ostream>

#include "addons/steps/steps.hpp"
#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

constexpr std::string_view first_line = "signorini-state-2";
constexpr std::string_view without_end =
    "signorini-state-1";  // of versions that did not mark the end
constexpr std::string_view last_line = "end";
constexpr const char* began = "last-step-began";           // only where bodies move
constexpr const char* elsewhere = "dissipated-elsewhere";  // too
constexpr std::string_view status_letters = "osfb";        // in the order of ContactStatus

/// The vectors of a state, by name.
template <typename State, typename Visit>
void visit_vectors(State& state, Visit&& visit) {
  visit("slip", state.slip);
  visit("increment", state.increment);
  visit("dissipation", state.dissipation);
  visit("force", state.solution.force);
  visit("displacement", state.solution.displacement);
  visit("displacement-low", state.solution.displacement_low);
  visit("rigid", state.solution.rigid);
}

/// The word after a name on the next line.
std::string_view word_after(TextReader& reader, const std::string& name) {
  if (!reader.next_line()) reader.fail(name, "");
  const std::string_view word = reader.word();
  if (word != name) reader.fail(name, word);
  return reader.word();
}

Index next_size(TextReader& reader, const std::string& name, Index least = 0) {
  const Index size = reader.size(word_after(reader, name), "size of " + name, least);
  reader.expect_end_of_line("the size of " + name);
  return size;
}

void write_vector(const char* name, const VectorXd& values, std::ostream& out) {
  out << name << ' ' << values.size() << '\n';
  for (const double value : values) out << shortest(value) << '\n';
}

void read_vector(TextReader& reader, const char* name, VectorXd& values) {
  values.resize(next_size(reader, name));
  reader.check_room(values.size(), 1, name);
  for (double& value : values) value = reader.number(reader.word_anywhere(), name);
}

/// Whether the file marks its end, by its first line.
bool marks_its_end(TextReader& reader) {
  reader.next_line();
  const std::string_view word = reader.word();
  if (word != first_line && word != without_end)
    reader.fail(text("a line with the single word '", first_line, "', or '", without_end,
                     "' of an older version"),
                word);
  reader.expect_end_of_line(std::string(word));
  return word == first_line;
}

/// What only bodies that move have, and the end of the file. \param marked  whether a line says that this is the end
void read_rest(TextReader& reader, bool marked, PathState& state) {
  const auto next = [&] { return reader.next_line() ? reader.word() : std::string_view(); };
  std::string_view word = next();
  if (word == began) {
    state.began = reader.number(reader.word(), began);
    reader.expect_end_of_line(began);
    read_vector(reader, "way", state.way);
    word = next();
  }
  if (word == elsewhere) {
    std::vector<double> each = {reader.number(reader.word(), elsewhere)};
    for (word = reader.word(); !word.empty(); word = reader.word())
      each.push_back(reader.number(word, elsewhere));
    state.dissipated_elsewhere =
        Eigen::Map<const VectorXd>(each.data(), static_cast<Index>(each.size()));
    word = next();
  }
  if (marked) {
    if (word != last_line)
      reader.fail(text("a line '", last_line, "', without which a part of the file is missing"),
                  word);
    reader.expect_end_of_line(std::string(last_line));
    word = next();
  }
  if (!word.empty()) reader.fail("the end of the file", word);
}

}  // namespace

void write_state(const PathState& state, std::ostream& out) {
  out << first_line << "\nsteps " << state.steps << "\ntime " << shortest(state.time) << "\nmotion "
      << state.contact_status.size() << '\n';
  for (const ContactStatus contact_status : state.contact_status)
    out << status_letters[static_cast<std::size_t>(contact_status)] << '\n';
  visit_vectors(state, [&](const char* name, const VectorXd& values) {
    write_vector(name, values, out);
  });
  if (state.began > 0) {
    out << began << ' ' << shortest(state.began) << '\n';
    write_vector("way", state.way, out);
  }
  if (state.dissipated_elsewhere.size() > 0) {
    out << elsewhere;
    for (const double one : state.dissipated_elsewhere) out << ' ' << shortest(one);
    out << '\n';
  }
  out << last_line << '\n';
}

PathState read_state(const std::string& content, const std::string& name) {
  TextReader reader(content, name);
  PathState state;
  const bool marked = marks_its_end(reader);
  state.steps = next_size(reader, "steps", 1);
  state.time = reader.number(word_after(reader, "time"), "time");
  reader.expect_end_of_line("time");
  if (!(state.time > 0)) reader.fail("time: expected a number > 0, got " + shortest(state.time));
  const Index pairs = next_size(reader, "motion");
  reader.check_room(pairs, 1, "motion");
  for (Index k = 0; k < pairs; ++k) {
    const std::string_view word = reader.word_anywhere();
    const std::size_t contact_status =
        word.size() == 1 ? status_letters.find(word) : std::string_view::npos;
    if (contact_status == std::string_view::npos) reader.fail("o, s, f or b", word);
    state.contact_status.push_back(static_cast<ContactStatus>(contact_status));
  }
  visit_vectors(state, [&](const char* what, VectorXd& values) {
    read_vector(reader, what, values);
  });
  read_rest(reader, marked, state);
  return state;
}

}  // namespace signorini
