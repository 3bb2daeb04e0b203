/// \file
/// Live figures: what a reader may change, and what the library then computes and shows. A page of the book
/// draws them in a browser; the same code runs in tests.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "addons/steps/steps.hpp"
#include "signorini/scene/readings.hpp"

/// Live figures of the book.
namespace live {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Something that the reader may change: a slider, or a list if it has choices. Its value is then the number of
/// the choice, from 0.
struct Control {
  std::string name;                       ///< in requests, without blanks
  std::string label;                      ///< for the reader, with the unit
  double value;                           ///< at the beginning
  double least = 0;                       ///< of a slider
  double most = 0;                        ///< of a slider
  double step = 1;                        ///< of a slider
  std::vector<std::string> choices = {};  ///< names, without blanks
  bool plays = false;     ///< a slider with a button that moves it to its end, step by step
  bool own_axes = false;  ///< each of its values is a problem of its own, with axes of its own
};

/// \param name,label,value,least,most,step  see Control \return a slider
[[nodiscard]] Control slider(std::string name, std::string label, double value, double least,
                             double most, double step);
/// \param name,label,choices  see Control \param value  the choice at the beginning \return a list
[[nodiscard]] Control choice(std::string name, std::string label, const std::string& value,
                             std::vector<std::string> choices);
/// \param name,label  see Control \param on  at the beginning \return the list of off and on, which pages show as a box
[[nodiscard]] Control toggle(std::string name, std::string label, bool on);
/// \param slider  of a load or a history \return the same with a button that plays it
[[nodiscard]] Control playing(Control slider);
/// \param control  that chooses a problem \return the same, whose values have axes of their own
[[nodiscard]] Control with_own_axes(Control control);

/// The values of all controls of a figure.
class Request {
 public:
  /// \param controls  of the figure
  /// \param words     `name=value`, with blanks between; a control that is not named has its value at the beginning
  /// \throws signorini::ProblemError for a name, number or choice that the figure does not have
  Request(const std::vector<Control>& controls, const std::string& words);

  /// \param name  of a control \return its value
  [[nodiscard]] double operator[](const std::string& name) const { return values_.at(name); }
  /// \param name  of a control \return its value as a whole number
  [[nodiscard]] Index whole(const std::string& name) const;
  /// \param name  of a list \return the choice
  [[nodiscard]] const std::string& chosen(const std::string& name) const;
  /// \param name  of a toggle \return whether it is on
  [[nodiscard]] bool on(const std::string& name) const { return values_.at(name) != 0; }
  /// All values but those of some controls, as a key for kept().
  /// \param without  names of controls \return text that differs where a value differs
  [[nodiscard]] std::string key(const std::vector<std::string>& without = {}) const;

 private:
  std::map<std::string, double> values_;
  std::map<std::string, std::vector<std::string>> choices_;
};

/// How a line, its points or an outline look, also without colour.
enum class Look {
  Line,    ///< solid
  Dashed,  ///< a closed form, or another method
  Dotted,  ///< a bound or an outline
  Closed,  ///< filled circles
  Open,    ///< hollow circles
  Cross,   ///< where something failed, or the exact answer
  Here,    ///< one large mark: where the reader is
  Arrow,   ///< arrows, each from a point to the next one
  Solid,   ///< an outline that is filled: a body that cannot deform
  Trail    ///< one point; those of earlier answers stay, joined along x if they are of one series
};

/// Something to draw into a panel.
struct Layer {
  std::string label;       ///< for the legend and for those who do not see it; empty: none
  Look look = Look::Line;  ///< of a line or points
  VectorXd x;  ///< `n`, or of the corners of all cells one after another; a NaN breaks a line
  VectorXd y;  ///< as many
  Index corners = 0;        ///< of each cell; 0: a line or points
  VectorXd value;           ///< of each cell: lightness, and colour for its sign
  double least = 0;         ///< begin of the scale of colours, <= 0
  double most = 1;          ///< its end, > 0; values beyond have the colour of the end
  bool mesh = false;        ///< whether the edges of the cells are drawn
  std::string series = {};  ///< of a trail: the settings that its line belongs to
  bool varies = false;      ///< not determined by the problem: it may be another in another program
};

/// A control that follows a pointer over a panel: its value is `from + x * px + y * py`.
struct Drag {
  std::string control;  ///< a slider
  double x;             ///< for one unit along x
  double y;             ///< for one unit along y
  double from = 0;      ///< at the origin
};

/// Axes with layers. Arrays are those of the last request.
struct Panel {
  std::string title;    ///< above the axes, and what they are called by those who do not see them
  std::string x_label;  ///< with the unit
  std::string y_label;  ///< with the unit
  bool equal = false;   ///< one length is one length along both axes
  bool log_x = false;   ///< logarithmic
  bool log_y = false;   ///< logarithmic
  std::vector<double> window = {};  ///< `{x0, x1, y0, y1}`, the same wherever the controls stand
  std::vector<Drag> drag = {};      ///< controls that follow a pointer
  bool grab = false;  ///< they follow from where they were, as an object that is held, not at once
  bool whole_x = false;  ///< only whole numbers along x
  bool whole_y = false;  ///< only whole numbers along y
  bool clips = false;    ///< some points lie beyond the window; an arrow at its edge shows where
  std::string question =
      {};  ///< what the reader draws before this panel and those behind it are shown; empty: nothing
  std::vector<Layer> layers = {};  ///< later ones lie above

  /// Adds a line or points. \param label,look,x,y  see Layer
  void curve(std::string label, Look look, const VectorXd& x, const VectorXd& y);
  /// Adds points in two looks. \param label,x,y  see Layer \param pressure  `n` \param some  what those are whose
  ///   pressure is > 0 \param none  what the others are
  void points(const std::string& label, const VectorXd& x, const VectorXd& y,
              const VectorXd& pressure, const char* some = "closed", const char* none = "open");
  /// Adds the closed pairs of a contact with friction: filled where they stick, hollow where they slide.
  /// \param x,y  `n_c` \param contact  solved
  void motions(const VectorXd& x, const VectorXd& y, const signorini::ContactState& contact);
  /// Adds where the reader is, on a line of where it has been. \param label  see Layer
  /// \param series  the settings besides x \param x,y  of this answer
  void trail(std::string label, std::string series, double x, double y);
  /// Adds cells. \param label  what the value is \param corner  `n x 2` places \param cell  `m x k` numbers of corners,
  ///   anticlockwise \param value  `m` \param most  end of the scale of colours
  void cells(std::string label, const MatrixXd& corner,
             const Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic>& cell,
             const VectorXd& value, double most);
  /// Adds a function on a grid of cells. \param label  what the value is
  /// \param x,y  lines of the grid, increasing \param value  at the middle of each cell \param least,most  see Layer
  void map(std::string label, const VectorXd& x, const VectorXd& y,
           const std::function<double(double, double)>& value, double least, double most);
  /// Adds a function over the triangle of three weights, see in_triangle(), and where to drag two of them.
  /// \param label  what the value is \param value  of the weights \param levels  of its lines \param words  what those are \param most  see Layer
  /// \param first,second  controls of the first two weights; empty: they are not dragged
  void triangle(std::string label, const std::function<double(const Eigen::Vector3d&)>& value,
                const std::vector<double>& levels, std::string words, double most,
                const std::string& first = "", const std::string& second = "");
  /// Adds the lines on which a function has certain values, nothing if it has them nowhere. \param label,look  see Layer
  /// \param x,y  lines of a grid, increasing; on each half of its cells the function is taken as plane
  /// \param value  at (x, y) \param levels  its values on the lines
  void level_lines(std::string label, Look look, const VectorXd& x, const VectorXd& y,
                   const std::function<double(double, double)>& value,
                   const std::vector<double>& levels);
  /// Adds a body, coloured by von Mises's stress. \param body  of a model \param displacement  `n x 2` that makes the stress
  /// \param place  `n x 2` where to draw its nodes \param most  end of the scale of stresses
  void body(const signorini::BodyModel& body, const signorini::NodeArray& displacement,
            const signorini::NodeArray& place, double most);
  /// Adds the deformed bodies of a scene, coloured by von Mises's stress.
  /// \param model  with its bodies \param solution  of it \param most  end of the scale of stresses
  /// \param magnified  displacements are drawn so many times as large
  void bodies(const signorini::Model& model, const signorini::Solution& solution, double most,
              double magnified = 1);
  /// Adds a pressure as arrows that end on a surface, and the line that joins their beginnings.
  /// \param label  see Layer \param place  `n x 2` on the surface \param push  `n x 2` the way the pressure pushes
  /// \param pressure  `n`, compression > 0 \param length  of the arrow of a pressure of one
  void arrows(std::string label, const signorini::NodeArray& place,
              const signorini::NodeArray& push, const VectorXd& pressure, double length);
  /// Adds the contact pressure of a scene on its deformed source, as arrows.
  /// \param model,solution,magnified  as bodies() \param length  as arrows() \param source  its body
  void pressure(const signorini::Model& model, const signorini::Solution& solution, double length,
                double magnified = 1, std::size_t source = 0);
};

/// \param weights  three, sum 1 \return where they lie in a triangle of sides 1: the first at (0, 0), the second at (1, 0), the
///   third above
[[nodiscard]] Eigen::Vector2d in_triangle(const Eigen::Vector3d& weights);

/// A number of an answer, shown beside the panels.
struct Number {
  std::string name;     ///< in tests
  std::string label;    ///< for the reader
  double value;         ///< in the unit
  std::string unit;     ///< behind the number
  const char* format;   ///< of printf, with one conversion of a double
  bool varies = false;  ///< of the size of rounding: it may be another in another program
};

/// Pairs, or other things with numbers, that are in a set.
struct Set {
  std::string name;            ///< in tests
  std::vector<Index> members;  ///< in increasing order
};

/// \param contact  solved, all its pairs with friction \param slide  whether to list those that slide, or that stick \return pairs
[[nodiscard]] std::vector<Index> closed_pairs(const signorini::ContactState& contact, bool slide);

/// What a figure answers to a request.
struct Answer {
  std::string says;  ///< in one or two sentences, also for those who do not see the panels
  std::vector<Number> numbers;  ///< beside the panels
  std::vector<Set> sets;        ///< which browsers must find exactly as the native program does
  std::vector<Panel> panels;    ///< drawn side by side
  std::vector<std::vector<std::string>> table =
      {};                  ///< its first row names the columns; none if empty
  std::string notes = {};  ///< what the library remarks, below all else

  /// Adds a number. \param name,label,value,unit,format  see Number
  void number(std::string name, std::string label, double value, std::string unit = "",
              const char* format = "%.4g");
  /// Adds a number of the size of rounding. \param name,label,value,unit  see Number
  void rounding(std::string name, std::string label, double value, std::string unit = "");
  /// Adds what every solution shows: closed pairs, iterations and the worst entry of the certificate, the set of closed
  /// pairs and, with friction, those that stick and that slide, and the notes.
  /// \param solution  of the figure's scene
  /// \param determined  whether the problem says which pairs are closed; else that is shown, and not compared
  void solution(const signorini::Solution& solution, bool determined = true);
};

/// A live figure.
struct Figure {
  std::string name;               ///< in requests and in the mark `live NAME` of a chapter's text
  std::string title;              ///< for the reader
  std::vector<Control> controls;  ///< in the order of the form
  std::function<Answer(const Request&)> answer;  ///< to the values of all controls
};

/// \return all live figures, in the order of the chapters
[[nodiscard]] const std::vector<Figure>& figures();

/// What was made for the request before, made again only if its key differs: a factor outlives changes of the load.
/// Each place in the code that calls this keeps one thing.
/// \param key  of what is made \param make  makes it \return what was made
template <typename Make>
auto& kept(const std::string& key, const Make& make) {
  static std::pair<std::string, std::vector<decltype(make())>> last;
  if (last.second.empty() || last.first != key) {
    last.second.clear();
    last.second.push_back(make());
    last.first = key;
  }
  return last.second.front();
}

/// A scene with load steps that is factored once, for any load.
struct Loaded {
  signorini::Model model;         ///< as loaded at the time that was asked for last
  signorini::CondensedPath path;  ///< with its factor

  /// \param scene  whose loads follow histories \param ledger  of the two steps
  explicit Loaded(const signorini::Scene& scene, signorini::Ledger ledger = {});
  /// Its solution under the loads of a time, from rest. \param time  > 0 \return certified
  /// \throws signorini::NotSolved as require_solved()
  [[nodiscard]] signorini::Solution at(double time);
  /// The same with copies of what it belongs to, for functions that read a solved scene. \param time  > 0
  /// \return model, condensed problem and solution
  [[nodiscard]] signorini::SolvedScene scene_at(double time);
};

/// Answers what a page asks: `figure NAME` tells its controls, `NAME control=value ...` computes.
/// \param words   the question
/// \param arrays  gets the numbers of all layers; the answer refers to them by their places
/// \return a JSON object; with the key `error` and a sentence if there is no answer
[[nodiscard]] std::string answer(const std::string& words, std::vector<VectorXd>& arrays);

}  // namespace live
