/// \file
/// Three ways to one end.
#pragma once
#include <string>
#include <vector>

#include "cylinder.hpp"
#include "signorini/core/table.hpp"

namespace ch15 {

constexpr double shift = 0.008;  // of the cylinder, in the end [mm]

/// A way to one end: down by `depth` and aside by `shift`.
struct Order {
  const char* name;
  History press, push;
};

inline std::vector<Order> orders() {
  return {{"down first", {"press", {0, 1}, {0, 1}}, {"push", {1, 2}, {0, shift}}},
          {"aside first", {"press", {1, 2}, {0, 1}}, {"push", {0, 1}, {0, shift}}},
          {"straight", {"press", {0, 2}, {0, 1}}, {"push", {0, 2}, {0, shift}}}};
}

/// Where a way to the end arrives.
struct End {
  double push = 0;        ///< over mu P [-]
  Eigen::VectorXd force;  ///< of all pairs [N]
};

/// Goes a way. \param scene  of the cylinder \param figure  gets the shear in the end, or null \param name  of the way
/// there \return where it arrives
inline End end_of(const Scene& scene, Table* figure = nullptr, const std::string& name = {}) {
  End end;
  remember(by_hand(scene), [&](const Model& model, const Step& step) {
    const ContactState& contact = step.solution.contact;
    end.force = contact.force;
    if (contact.friction.size() == 0) return;
    end.push = -contact.friction.sum() / (mu * contact.force.sum());
    if (!figure || step.state.time < scene.path->times.back()) return;
    const Eigen::VectorXd shear = shear_of(model, step);
    for (Index i = 0; i < shear.size(); ++i)
      figure->row({name, number(model.pairs.position(i, 0)), number(shear(i)),
                   number(mu * step.solution.pressure(i))});
    figure->blank_line();
  });
  return end;
}

}  // namespace ch15
