// one body of quadrilaterals and triangles, and one of triangles that shares a curve with it
SetFactory("Built-in");
Point(1)={0,0,0}; Point(2)={1,0,0}; Point(3)={2,0,0}; Point(4)={2,1,0}; Point(5)={1,1,0}; Point(6)={0,1,0}; Point(7)={1,2,0};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,5}; Line(5)={5,6}; Line(6)={6,1}; Line(7)={2,5}; Circle(8)={4,5,7}; Circle(9)={7,5,6};
Curve Loop(1)={1,7,5,6}; Plane Surface(1)={1};
Curve Loop(2)={2,3,4,-7}; Plane Surface(2)={2};
Curve Loop(3)={-5,-4,8,9}; Plane Surface(3)={3};
Transfinite Curve{1,2,3,4,5,6,7,8,9}=3; Transfinite Surface{1}; Recombine Surface{1};
Mesh.MeshSizeMax=0.5;
Physical Surface("plate",1)={1,2}; Physical Surface("arch",2)={3};
Physical Curve("base",1)={1,2}; Physical Curve("shared",2)={4,5}; Physical Curve("round",3)={8,9};
