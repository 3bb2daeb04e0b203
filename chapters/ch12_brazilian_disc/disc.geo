// The right half of the disc, fine at the poles.  disc.msh is what Gmsh 4.8.4 makes of it:
//   gmsh -2 -format msh41 disc.geo
SetFactory("Built-in");
R = 50;
Point(1) = {0, 0, 0};
Point(2) = {0, R, 0};
Point(3) = {R, R, 0};
Point(4) = {0, 2 * R, 0};
Circle(1) = {1, 2, 3};
Circle(2) = {3, 2, 4};
Line(3) = {4, 2};
Line(4) = {2, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Field[1] = Distance;
Field[1].PointsList = {1, 4};
Field[2] = MathEval;
Field[2].F = "Max(0.08, Min(0.16 * F1 - 0.1, 2.5))";  // size of the cells [mm]
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombinationAlgorithm = 2;
Recombine Surface{1};
Physical Curve("rim") = {1, 2};
Physical Curve("axis") = {3, 4};
Physical Surface("disc") = {1};
