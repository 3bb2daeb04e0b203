/// \file
/// Closest points in exact fractions, for problems with K = I small enough to try every set of rows.
#pragma once
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/fraction.hpp"

namespace exact {

using Vector = std::vector<Fraction>;
using Rows = std::vector<Vector>;
using Set = std::vector<std::size_t>;

inline Fraction dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Fraction());
}

/// a + t b
inline Vector along(Vector a, Fraction t, const Vector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + t * b[i];
  return a;
}

/// Such as (1, -7/6).
inline std::string text_of(const Vector& x) {
  std::string list;
  for (const Fraction& f : x) list += (list.empty() ? "(" : ", ") + f.text();
  return list + ")";
}

/// The solution of M x = r, or nothing if M is singular.
inline Vector solve(Rows M, Vector r) {
  for (std::size_t k = 0; k < r.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < r.size() && M[pivot][k] == 0) ++pivot;
    if (pivot == r.size()) return {};
    std::swap(M[k], M[pivot]);
    std::swap(r[k], r[pivot]);
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (i == k) continue;
      const Fraction factor = M[i][k] / M[k][k];
      M[i] = along(M[i], Fraction() - factor, M[k]);
      r[i] = r[i] - factor * r[k];
    }
  }
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = r[k] / M[k][k];
  return r;
}

/// Least 1/2 u.u - p.u with A u <= g.
struct Programme {
  Rows A;
  Vector g;
  Vector p;
};

inline Fraction gap(const Programme& q, std::size_t row, const Vector& u) {
  return q.g[row] - dot(q.A[row], u);
}

inline Fraction energy(const Programme& q, const Vector& u) {
  return dot(u, u) * Fraction(1, 2) - dot(q.p, u);
}

/// Rows whose gap is negative, or zero.
inline Set rows_with(const Programme& q, const Vector& u, int sign) {
  Set found;
  for (std::size_t i = 0; i < q.g.size(); ++i)
    if (sign < 0 ? gap(q, i, u) < 0 : gap(q, i, u) == 0) found.push_back(i);
  return found;
}

/// A point and the forces that hold it, 0 for the rows that are left out.
struct Rest {
  Vector u;
  Vector force;
};

/// Closes some rows of a body that would rest at `start` without them; forces of any sign.
inline Rest solve_active_set(const Programme& q, const Set& rows, const Vector& start) {
  Rows G(rows.size(), Vector(rows.size()));
  Vector overlap;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    overlap.push_back(Fraction() - gap(q, rows[i], start));
    for (std::size_t j = 0; j < rows.size(); ++j) G[i][j] = dot(q.A[rows[i]], q.A[rows[j]]);
  }
  const Vector forces = solve(G, overlap);
  Rest rest{forces.size() == rows.size() ? start : Vector(), Vector(q.g.size())};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    rest.force[rows[i]] = forces[i];
    rest.u = along(rest.u, Fraction() - forces[i], q.A[rows[i]]);
  }
  return rest;
}

/// The point closest to `start` that satisfies some rows, by trying every set of closed ones.
inline Rest closest(const Programme& q, const Set& rows, const Vector& start) {
  for (std::size_t code = 0; code < (std::size_t{1} << rows.size()); ++code) {
    Set closed;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if ((code >> k & 1U) != 0) closed.push_back(rows[k]);
    Rest rest = solve_active_set(q, closed, start);
    bool right = !rest.u.empty();
    for (const std::size_t i : rows)
      right = right && !(rest.force[i] < 0) && !(gap(q, i, rest.u) < 0);
    if (right) return rest;
  }
  throw std::domain_error("closest: the rows contradict each other");
}

}  // namespace exact
