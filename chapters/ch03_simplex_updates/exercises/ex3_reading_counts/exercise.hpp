/// \file
/// Exercise 3.3 - reading counts. Do not change this file.
#pragma once

namespace ex3_3 {

/// Forecasts for the punch of the chapter.
struct Answers {
  double harmonic_power =
      0;  ///< alpha: by the steps 2/(k + 2) what is missing falls like k^-alpha, to 0.1
  int harmonic_5 = 0;  ///< iterations of these steps until 1e-5 is missing, to 10 %
  double away_digit =
      0;  ///< iterations that away steps take for a digit more, once they are under way, to 10 %
  int away_10 = 0;      ///< iterations of away steps until 1e-10 is missing, to 10 %
  int pairwise_10 = 0;  ///< iterations of the pairwise rule until 1e-10 is missing, to 10 %
  int corrective_12 =
      0;               ///< iterations of the fully corrective rule until 1e-12 is missing, exactly
  int reaching_6 = 0;  ///< rules that reach 1e-6 within 20 000 iterations, of the six
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex3_3
