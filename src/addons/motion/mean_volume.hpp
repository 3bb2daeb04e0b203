// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Points of a cell under finite strain, and their mean change of volume.
#pragma once
#include <array>
#include <vector>

#include "addons/motion/finite_strain.hpp"

namespace signorini {

/// From displacements `2m` of a cell to the components of a gradient.
using GradientMap = Eigen::Matrix<double, 5, Eigen::Dynamic, Eigen::ColMajor, 5, 2 * max_cell_nodes>;

/// One point of a cell: its map G and its gradient.
struct CellPlace {
  double volume;  ///< before strain [length^3]
  GradientMap G;  ///< `5 x 2m` [1/length]
  Components H;   ///< G u [-]
};

/// ln r of all points of a cell whose change of volume is averaged, and its derivatives.
struct MeanVolume {
  std::array<double, max_strain_points> log;           ///< [-]
  std::array<CellVector, max_strain_points> gradient;  ///< `2m` [1/length]
  std::array<CellMatrix, max_strain_points> curvature; ///< `2m x 2m` [1/length^2]
};

/// \param places  of a cell, with J > 0
/// \param across  whether the strain across counts; not in plane stress, where it follows
/// \param[out] mean  of them
void mean_volume(const std::vector<CellPlace>& places, bool across, MeanVolume& mean);

/// Scales the gradient in the plane by r. \param mean  of the cell \param q  number of the point \param[in,out] at  the point
void scale_gradient(const MeanVolume& mean, std::size_t q, CellPlace& at);

/// Takes G to the scaled gradient, and adds the second derivative of that gradient to the tangent of a cell.
/// \param mean   of the cell
/// \param q      number of the point
/// \param piola  the stress there
/// \param[in,out] at  the point, behind scale_gradient()
/// \param[in,out] tangent  of the cell
void scale_map(const MeanVolume& mean, std::size_t q, const Components& piola, CellPlace& at,
               CellMatrix& tangent);

}  // namespace signorini
