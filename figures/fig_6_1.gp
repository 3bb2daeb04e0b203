# Figure 6.1 - the cantilever of the paper: sketch and mesh.   In: fig_6_1.csv   Out: fig_6_1.svg
width = 480; height = 210
load 'style.gp'
unset key; unset grid; unset border; unset xtics; unset ytics
set margins 0, 0, 0, 0
set size ratio -1
set xrange [-3.5:68.5]
set yrange [-13.7:16.5]
set style arrow 1 head filled size 1.2,18 ls 7   # load
set style arrow 2 heads filled size 1.2,18 ls 7  # dimensions
set style arrow 3 nohead ls 7 lw 1               # their help lines
set style arrow 4 nohead ls 7 dt (5,4)           # chosen: our copy of the paper does not show it
# clamp
do for [k=0:6] { set arrow from 0,-1.5+k*1.3 to -1.8,-2.8+k*1.3 as 3 }
set arrow from 0,-2 to 0,7 nohead ls 7 lw 2
# load
do for [k=0:10] { set arrow from k*5,11 to k*5,6.6 as 4; set arrow from k*5,6.7 to k*5,5.2 as 1 }
set arrow from 0,11 to 50,11 as 4
set label 'load {/:Italic q} = 3.6 kN/cm²' at 25,13.4 center
# foundation
set object 1 rectangle from -3,-3.4 to 64,-1 fc rgb LIGHT fs solid noborder behind
set arrow from -3,-1 to 64,-1 as 4
set label 'rigid foundation' at 1.5,-5.2 left
# dimensions
set arrow from 0,-3 to 0,-10.5 as 3
set arrow from 50,-0.2 to 50,-10.5 as 3
set arrow from 0,-9.5 to 50,-9.5 as 2
set label '{/:Italic l} = 50 cm' at 25,-11.9 center
set arrow from 50.5,5 to 57,5 as 3
set arrow from 50.5,0 to 57,0 as 3
set arrow from 56,0 to 56,5 as 2
set label '{/:Italic h} = 5 cm' at 57.2,2.5 left
set arrow from 53,3 to 53,0 as 1
set arrow from 53,-6 to 53,-1 as 1
set label 'gap {/:Italic g} = 1 cm' at 53.8,-5.2 left
plot data.'/fig_6_1.csv' using 'x':'y' with lines lc rgb BLUE lw 0.7 dt 1
