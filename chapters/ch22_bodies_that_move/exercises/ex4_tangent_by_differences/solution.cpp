#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "exercise.hpp"

namespace ex22_4 {

Matrix2d stress(const Material& material, const Matrix2d& F) {
  const Matrix2d inverse = F.inverse().transpose();
  return material.mu * (F - inverse) + material.lambda * std::log(F.determinant()) * inverse;
}

Matrix2d tangent(const Material& material, const Matrix2d& F, const Matrix2d& direction) {
  const Matrix2d inverse = F.inverse().transpose();
  const double volume = (inverse.transpose() * direction).trace();  // of ln J
  const Matrix2d turned = -inverse * direction.transpose() * inverse;  // of F^-T
  return material.mu * (direction - turned) +
         material.lambda * (volume * inverse + std::log(F.determinant()) * turned);
}

Matrix2d by_differences(const std::function<Matrix2d(const Matrix2d&)>& of, const Matrix2d& F,
                        const Matrix2d& direction) {
  const double h = std::cbrt(std::numeric_limits<double>::epsilon()) / direction.norm();
  return (of(F + h * direction) - of(F - h * direction)) / (2 * h);
}

}  // namespace ex22_4
