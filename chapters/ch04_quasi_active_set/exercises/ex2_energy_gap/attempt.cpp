#include "exercise.hpp"

namespace ex4_2 {

End last_step(const signorini::DenseProgramme& /*programme*/, const Balanced& from,
              const Balanced& /*towards*/) {
  End end;
  end.state = from;
  // your code here: delta, the mixture of both states, its energy, the gap
  return end;
}

}  // namespace ex4_2
