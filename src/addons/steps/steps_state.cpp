#include <algorithm>
#include <array>
#include <ostream>

#include "addons/steps/steps.hpp"
#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// The first lines of all versions: the first did not mark the end, the second had forces in one part, and a way of u alone.
constexpr std::array<std::string_view, 3> first_lines = {"signorini-state-1", "signorini-state-2",
                                                         "signorini-state-3"};
constexpr std::string_view last_line = "end";
constexpr const char* began = "last-step-began";           // behind the first step
constexpr const char* elsewhere = "dissipated-elsewhere";  // only where bodies move
constexpr std::string_view status_letters = "osfb";        // in the order of ContactStatus

/// The vectors of a state, by name.
template <typename State, typename Visit>
void visit_vectors(State& state, std::size_t version, Visit&& visit) {
  visit("slip", state.slip);
  visit("increment", state.increment);
  visit("dissipation", state.dissipation);
  visit("force", state.solution.force);
  visit("displacement", state.solution.displacement);
  visit("displacement-low", state.solution.displacement_low);
  visit("rigid", state.solution.rigid);
  if (version >= 3) visit("force-low", state.solution.force_low);
}

/// Those of the way to it.
template <typename State, typename Visit>
void visit_way(State& state, std::size_t version, Visit&& visit) {
  visit("way", state.way.displacement);
  if (version < 3) return;
  visit("way-low", state.way.displacement_low);
  visit("way-force", state.way.force);
  visit("way-force-low", state.way.force_low);
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

/// \return the version of a file, from 1
std::size_t version_of(TextReader& reader) {
  reader.next_line();
  const std::string_view word = reader.word();
  const auto found = std::find(first_lines.begin(), first_lines.end(), word);
  if (found == first_lines.end())
    reader.fail(text("a line with the single word '", first_lines.back(), "', or '", first_lines[1], "' or '",
                     first_lines[0], "' of an older version"),
                word);
  reader.expect_end_of_line(std::string(word));
  return static_cast<std::size_t>(found - first_lines.begin()) + 1;
}

/// The way to a state, what only bodies that move have, and the end of the file.
void read_rest(TextReader& reader, std::size_t version, PathState& state) {
  const auto next = [&] { return reader.next_line() ? reader.word() : std::string_view(); };
  std::string_view word = next();
  if (word == began) {
    state.began = reader.number(reader.word(), began);
    reader.expect_end_of_line(began);
    visit_way(state, version,
              [&](const char* name, VectorXd& values) { read_vector(reader, name, values); });
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
  if (version >= 2) {
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
  const std::size_t version = first_lines.size();
  const auto write = [&](const char* name, const VectorXd& values) {
    write_vector(name, values, out);
  };
  out << first_lines.back() << "\nsteps " << state.steps << "\ntime " << shortest(state.time) << "\nmotion "
      << state.contact_status.size() << '\n';
  for (const ContactStatus contact_status : state.contact_status)
    out << status_letters[static_cast<std::size_t>(contact_status)] << '\n';
  visit_vectors(state, version, write);
  if (state.began > 0) {
    out << began << ' ' << shortest(state.began) << '\n';
    visit_way(state, version, write);
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
  const std::size_t version = version_of(reader);
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
  visit_vectors(state, version, [&](const char* what, VectorXd& values) {
    read_vector(reader, what, values);
  });
  read_rest(reader, version, state);
  return state;
}

}  // namespace signorini
