/// \file
/// Finite strain of a cell, for any law that gives the energy of a displacement gradient.
#pragma once
#include <Eigen/Core>

#include "signorini/fem/strain_law.hpp"

namespace signorini {

/// Components of a gradient or of a first Piola stress: 11, 12, 21, 22 in the plane, and 33 across it.
using Components = Eigen::Matrix<double, 5, 1>;

/// What a law says of a place.
struct StressResponse {
  Components piola;  ///< P, the derivative of the energy by H [force/length^2]
  Eigen::Matrix<double, 5, 5> tangent;  ///< the derivative of P by H [force/length^2]
  double energy = 0;                    ///< per volume before strain [force/length^2]
};

/// Lame's constants.
struct Lame {
  double lambda;  ///< [force/length^2]
  double mu;      ///< [force/length^2]
};

/// A law: what a displacement gradient H = F - 1 makes. It is given H and not F, whose 1 would take its digits. det F > 0.
using HyperelasticLaw = void (*)(const Lame& lame, const Components& H, StressResponse& response);

/// \param H  a displacement gradient
/// \return det F - 1 of the block in the plane, summed so that small H keeps its digits
[[nodiscard]] inline double area_change(const Components& H) {
  return H(0) + H(3) + (H(0) * H(3) - H(1) * H(2));
}

/// \param H  a displacement gradient
/// \return F = 1 + H
[[nodiscard]] inline Components deformation(const Components& H) {
  return H + (Components() << 1, 0, 0, 1, 1).finished();
}

/// Forces, tangent, true stress and energy of a cell, total Lagrangian: all integrals are over the cell before strain, at the
/// strain points of its element. In plane stress the strain across is that without stress there. Where the element has the
/// change of volume averaged, the gradient in the plane is scaled by \f$ (\bar J/J)^{1/2} \f$, \f$ \bar J \f$ the mean of J.
/// \param law           of its material
/// \param cell          of an element without internal modes
/// \param displacement  `2m`, see StrainLaw::answer [length]
/// \param answer        is filled
/// \throws ProblemError naming the cell if J <= 0 at one of its points, or if no strain across leaves a sheet without stress
void finite_answer(HyperelasticLaw law, const Cell& cell, const CellVector& displacement,
                   CellAnswer& answer);

/// \param law           of its material
/// \param cell          as above
/// \param displacement  `2m` [length]
/// \return of its points the least stiffness against plane waves, see least_wave_stiffness() [force/length^2]
/// \throws ProblemError as finite_answer()
[[nodiscard]] double finite_stability(HyperelasticLaw law, const Cell& cell,
                                      const CellVector& displacement);

/// A member of the family. \param name  of it \param help  what it is for \return the law
template <HyperelasticLaw law>
StrainLaw hyperelastic(const char* name, const char* help) {
  return {name, help,
          [](const Cell& cell, const CellVector& displacement, CellAnswer& answer) {
            finite_answer(law, cell, displacement, answer);
          },
          [](const Cell& cell, const CellVector& displacement) {
            return finite_stability(law, cell, displacement);
          }};
}

/// \f$ W = \tfrac\lambda2 (\mathrm{tr} E)^2 + \mu\, E : E \f$ with Green's strain E. It gives way in compression: a bar loses
/// all resistance at a stretch of 0.577.
/// \return the law
[[nodiscard]] StrainLaw st_venant_kirchhoff();
/// \f$ W = \tfrac\mu2 (F : F - 3 - 2\ln J) + \tfrac\lambda2 (\ln J)^2 \f$, which resists any compression.
/// \return the law
[[nodiscard]] StrainLaw neo_hooke();

}  // namespace signorini
