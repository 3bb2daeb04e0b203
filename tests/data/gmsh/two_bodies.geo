// two bodies that share a curve
SetFactory("Built-in");
Point(1)={0,0,0}; Point(2)={2,0,0}; Point(3)={2,1,0}; Point(4)={0,1,0}; Point(5)={2,2,0}; Point(6)={0,2,0};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1}; Line(5)={3,5}; Line(6)={5,6}; Line(7)={6,4};
Curve Loop(1)={1,2,3,4}; Plane Surface(1)={1};
Curve Loop(2)={3,-7,-6,-5}; Plane Surface(2)={2};
Transfinite Curve{1,3,6}=3; Transfinite Curve{2,4,5,7}=2; Transfinite Surface{1,2}; Recombine Surface{1,2};
Physical Surface("lower plate")={1}; Physical Surface("upper",7)={2};
Physical Curve("shared")={-3}; Physical Curve("outer")={1,2,4,-7,6,5}; Physical Curve("top")={6}; Physical Point("p")={1};
