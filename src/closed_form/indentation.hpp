/// \file
/// Rigid or elastic bodies of several shapes pressed on a half-plane without friction.
///
/// A contact search that knows only the ellipse of Hertz fails on them: the quartic has its largest
/// pressure off the middle, the wedge an infinite one in it, the rounded punch one near its edges.
/// All pressures p solve \f$ \frac{2}{\pi E^{*}}\,\mathrm{PV}\!\int_{-a}^{a} \frac{p(s)}{x - s}\,ds
/// = h'(x) \f$ and vanish at the edges of the contact [\ref Johnson1985].
#pragma once

namespace signorini {

/// Shape of the gap h(x) before the load; `size` and `flat` are those of Indenter.
enum class IndenterShape {
  Parabola,     ///< x^2 / (2 R), size R [length]: a cylinder
  Quartic,      ///< A x^4, size A [1/length^3]
  Wedge,        ///< t |x|, size t [-], small: both flanks at the slope t
  RoundedPunch  ///< 0 for |x| < f, (|x| - f)^2 / (2 R) beyond, size R [length], flat f [length]
};

/// A body above a half-plane.
struct Indenter {
  IndenterShape shape;  ///< of its lower side
  double modulus;       ///< E* as contact_modulus() [force/length^2], > 0
  double size;          ///< see IndenterShape, > 0
  double flat = 0;      ///< half of the flat part of a rounded punch [length], > 0; else not used
};

/// Gap before the load.
/// \param indenter  any
/// \param x         from the axis [length]
/// \return h [length]
/// \throws std::invalid_argument if a size is out of range
[[nodiscard]] double indenter_gap(const Indenter& indenter, double x);

/// Load that makes a contact of the half-width a.
///
/// Parabola \f$ \pi E^{*} a^2 / (4 R) \f$, quartic \f$ \tfrac{3 \pi}{4} E^{*} A a^4 \f$, wedge
/// \f$ E^{*} t a \f$, rounded punch with \f$ \sin\varphi_0 = f / a \f$:
/// \f$ \frac{E^{*} a^2}{4 R} (\pi - 2 \varphi_0 - \sin 2 \varphi_0) \f$.
/// \param indenter    any
/// \param half_width  a [length], > 0, of a rounded punch > f
/// \return P [force/length]
/// \throws std::invalid_argument if a size or the half-width is out of range
[[nodiscard]] double indentation_load(const Indenter& indenter, double half_width);

/// Half-width under a load: the inverse of indentation_load(), by bisection to rounding.
/// \param indenter  any
/// \param load      P [force/length], > 0
/// \return a [length]
/// \throws std::invalid_argument if a size is out of range or the load not positive
[[nodiscard]] double indentation_half_width(const Indenter& indenter, double load);

/// Contact pressure.
///
/// Parabola \f$ \frac{E^{*}}{2 R} \sqrt{a^2 - x^2} \f$; quartic
/// \f$ E^{*} A (2 x^2 + a^2) \sqrt{a^2 - x^2} \f$; wedge
/// \f$ \frac{E^{*} t}{\pi} \mathrm{arcosh} \frac{a}{|x|} \f$; rounded punch [\ref CiavarellaHillsMonno1998]
/// with \f$ |x| = a \sin\varphi \f$
/// \f[ \frac{E^{*} a}{2 \pi R} \Big[(\pi - 2 \varphi_0) \cos\varphi +
///     \sin\varphi \ln\Big|\frac{\sin(\varphi + \varphi_0)}{\sin(\varphi - \varphi_0)}\Big| +
///     \sin\varphi_0 \ln\Big|\tan\frac{\varphi + \varphi_0}{2}
///     \tan\frac{\varphi - \varphi_0}{2}\Big|\Big]. \f]
/// \param indenter    any
/// \param half_width  a [length], see indentation_load()
/// \param x           from the axis [length]
/// \return pressure [force/length^2], compression > 0, 0 outside; infinite at the tip of the wedge
/// \throws std::invalid_argument as indentation_load()
[[nodiscard]] double indentation_pressure(const Indenter& indenter, double half_width, double x);

}  // namespace signorini
