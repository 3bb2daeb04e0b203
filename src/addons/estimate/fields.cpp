#include "addons/estimate/fields.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {

void check_primal_and_duals(const PrimalAndDuals& fields) {
  for (const NodeArray& u : fields.displacements)
    require_argument(u.rows() == fields.mesh.n_nodes(), "recovery: need the displacements of ",
                     fields.mesh.n_nodes(), " nodes, got ", u.rows());
}

}  // namespace signorini
