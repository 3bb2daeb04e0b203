#include "exercise.hpp"

namespace ex11_5 {

Orders orders(double /*power*/, double /*influence*/, int degree) {
  return {1.0 * degree, degree + 1.0, 2.0 * degree};  // of a smooth solution: change it
}

double times_more_cells(double /*part*/, double /*order*/) {
  return 1;  // your code here
}

}  // namespace ex11_5
