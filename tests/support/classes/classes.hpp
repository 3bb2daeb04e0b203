// The makers of the instances of all classes, by the file that holds them.
#pragma once
#include <string>
#include <vector>

#include "support/problem_classes.hpp"
#include "support/random.hpp"

namespace signorini_test {

using Instances = std::vector<Instance>;

/// Entries in [-1, 1).
Eigen::MatrixXd random_rows(Random& random, Eigen::Index rows, Eigen::Index cols);

/// K = I and rows A, built backwards: the closest point u, forces, and gaps that must come out.
Instance closest_point(std::string name, const Eigen::MatrixXd& A, const Eigen::VectorXd& u,
                       const Eigen::VectorXd& force, const Eigen::VectorXd& gap);

// plain.cpp: what every solver should find easy
Instances empty_problem();
Instances one_pair();
Instances two_pairs();
Instances none_active();
Instances all_active();
Instances built_backwards();

// programmes.cpp: K, p, A, g
Instances small_programme();
Instances rosen_suzuki_few();   // m <= n
Instances rosen_suzuki_many();  // m > n
Instances stiff_mode();         // cond(K) 1e6, 1e10, 1e13
Instances soft_mode();          // cond(K) and cond(G) 1e6
Instances equations();          // some rows of a programme hold with =

// rows.cpp: what rows of A can do to a method
Instances weakly_active();
Instances half_zero();
Instances duplicated_rows();
Instances redundant_rows();
Instances rounded_dependent_rows();

// parallel.cpp: rows that nearly repeat each other, of very different size, too many
Instances near_parallel_4();
Instances near_parallel_8();
Instances near_parallel_12();
Instances scaled_rows();
Instances many_violated();

// whole.cpp: small whole numbers, and contradictions
Instances whole_independent();
Instances whole_dependent();
Instances whole_infeasible();
Instances wedged();
Instances simplex_turned_out();

// bodies.cpp: contact of elastic bodies
Instances block_on_obstacle();
Instances cantilever_on_foundation();
Instances pin_in_hole_of_a_plate();
Instances lining_in_rock();
Instances half_plane();
Instances half_plane_large();
Instances string_over_wave();

// friction.cpp: frictional pairs
Instances friction_one_pair();
Instances friction_moderate();
Instances friction_strong();
Instances friction_none();
Instances friction_of_some();
Instances friction_cohesion();
Instances friction_floating();
Instances friction_cylinder();
Instances friction_cylinder_away();
Instances friction_siconos();

// floating.cpp: bodies that supports leave free to move
Instances bar_on_springs();
Instances bar_pulled_away();
Instances bar_undecided();
Instances punch();
Instances walls_too_close();
Instances floating_backwards();

// literature.cpp: problems that defeated methods before
Instances cycling();
Instances cycling_asymmetric();
Instances fathi();
Instances murty();

// files.cpp: problems of other collections
Instances generated_files();
Instances siconos_regular();
Instances siconos_semidefinite();
Instances siconos_asymmetric();
Instances siconos_singular();
Instances siconos_infeasible();
Instances maros_meszaros_rows();
Instances maros_meszaros_equations();

}  // namespace signorini_test
