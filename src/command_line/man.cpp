#include "command_line/man.hpp"

#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace command_line {
namespace {

/// The command that was parsed, or the program.
const CLI::App& chosen(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app : *parsed.front();
}

/// Marks what roff would read as its own.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && result.empty()) {
      result += "\\&";
      result += c;
    } else {
      result += c;
    }
  }
  return result;
}

/// The value of an option, such as NAME; empty for a flag.
std::string value_of(const CLI::Option& option) {
  return option.get_expected_max() > 0 ? option.get_type_name() : "";
}

void describe(std::string& page, const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string value = option->get_positional() ? "" : value_of(*option);
    page +=
        ".TP\n\\fB" + roff(option->get_name()) + "\\fR" +
        (value.empty() ? "" : " \\fI" + roff(value) + "\\fR") + "\n" +
        roff(option->get_description()) +
        (option->get_default_str().empty() ? "" : " [" + roff(option->get_default_str()) + "]") +
        "\n";
  }
}

std::vector<std::string> known_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional()) names.push_back(option->get_name());
  return names;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  std::string page = ".TH SIGNORINI 1 \"\" \"signorini " + version +
                     "\" \"User Commands\"\n.SH NAME\nsignorini \\- contact problems in the plane, "
                     "solved and certified\n.SH SYNOPSIS\n";
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* command : commands)
    page += "\\fBsignorini " + roff(command->get_name()) + "\\fR \\fIFILE\\fR [options]\n.br\n";
  page += "\\fBsignorini\\fR option\n.SH DESCRIPTION\n" + roff(app.get_description()) +
          ".\n.SH OPTIONS\n";
  describe(page, app);
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : commands) {
    page += ".SS signorini " + roff(command->get_name()) + "\n" + roff(command->get_description()) +
            ".\n";
    describe(page, *command);
  }
  return page + ".SH EXIT STATUS\n" + roff(app.get_footer()) + "\n";
}

std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& own = chosen(app);
  const std::string name = own.get_name();
  const std::string help =
      signorini::text(". Try signorini ", &own == &app ? "" : name + " ", "--help");
  const std::string said = error.what();
  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (code == CLI::ExitCodes::ExtrasError) {
    const std::vector<std::string> extra = app.remaining(true);
    const std::string first = extra.empty() ? "" : extra.front();
    if (!first.empty() && first[0] == '-')
      return "unknown option " + signorini::in_quotes(first) +
             signorini::suggestion(first, known_options(own)) + help;
    return "expected one FILE, got also '" + first + "'" + help;
  }
  if (code == CLI::ExitCodes::RequiredError)
    return "FILE is required: signorini " + name + " FILE" + help;
  if (code == CLI::ExitCodes::ArgumentMismatch)
    return said.substr(0, said.find(':')) + ": expected a value" + help;
  return said + help;
}

}  // namespace command_line
