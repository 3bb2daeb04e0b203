// Random bodies for random scenes: numbers, units, places, materials and meshes.
#pragma once
#include <initializer_list>
#include <string>

#include "meshes/ring.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// Numbers that are the same on every platform: whole ones, and single roundings of them.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}
  /// Whether something happens, n times in sixteen.
  bool chance(int n) { return random_.whole(1, 16) <= n; }
  int whole(int low, int high) { return random_.whole(low, high); }
  double sixteenths(int low, int high) { return random_.whole(low, high) / 16.0; }
  /// A power of ten.
  double decade(int low, int high);
  template <typename T>
  T pick(std::initializer_list<T> from) {
    return *(from.begin() + random_.whole(0, static_cast<int>(from.size()) - 1));
  }
  template <typename... Parts>
  void say(const Parts&... parts) {
    text += signorini::text(parts...);
  }
  std::string text;  ///< what was drawn, in words

 private:
  Random random_;
};

/// Bodies that are drawn about 1 long and 1 stiff, with the place of contact at the origin and the upper one
/// above it, and go from there to their units and their place.
class RandomBodies {
 public:
  /// \param draws  must outlive the bodies \param straight  whether sides are to stay parallel to the axes
  RandomBodies(Draws& draws, bool straight);

  double length = 1;                   ///< unit [length]
  double stress = 1;                   ///< unit [force/length^2]
  double load = 1;                     ///< over the unit of stress; 0: no loads
  double gap = 0;                      ///< in the unit of length
  double width = 1;                    ///< of the last body above, in the unit of length
  Eigen::Vector2d direction{1, 0};     ///< of the x axis that bodies are drawn in
  Eigen::Vector2d shift = {0.0, 0.0};  ///< of their origin [length]

  [[nodiscard]] Eigen::Vector2d turned(const Eigen::Vector2d& v) const;
  [[nodiscard]] Eigen::Vector2d placed(const Eigen::Vector2d& x) const;

  signorini::Body block_above(const std::string& name);
  signorini::Body block_below(const std::string& name);
  signorini::Body full_disc(const std::string& name);
  signorini::Body quarter_disc(const std::string& name);  ///< or the right half; with its supports
  signorini::Body half_space(const std::string& name);    ///< with its supports
  signorini::Body ring(const std::string& name, double inner, double outer,
                       signorini::Sector sector);

 private:
  signorini::MeshOrder draw_element(signorini::Body& body);
  signorini::Body finished(signorini::Body body, const signorini::Mesh& mesh);

  Draws& draw_;
  bool first_ = true;
};

}  // namespace signorini_test
