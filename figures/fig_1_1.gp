# Figure 1.1 - the block, its supports and the obstacle, with the mesh of 8 x 4 cells.
# In: fig_1_1.csv, fig_1_1_nodes.csv, fig_1_1_obstacle.csv   Out: fig_1_1.svg
height = 470
load 'style.gp'
unset grid
unset border
unset tics
unset key
set lmargin 1
set rmargin 1
set bmargin 0.5
set tmargin 0.5
set xrange [-31:31]
set yrange [-12.5:32]
set size ratio -1
set object 1 rectangle from -20,20 to 20,22 fillstyle pattern 4 border lc rgb BLACK fillcolor rgb BLACK
do for [i=0:2] { set arrow 1+i from -14+14*i,26.5 to -14+14*i,22.3 size screen 0.018,20 filled lc rgb RED lw 2.5 }
set label 1 '1 mm' at 2,24.6 left textcolor rgb BLACK front
set arrow 5 from -20,29 to 20,29 heads size screen 0.015,20 lc rgb BLACK front
set label 2 '40 mm' at 0,30.8 center textcolor rgb BLACK front
set arrow 6 from 23,0 to 23,20 heads size screen 0.015,20 lc rgb BLACK front
set label 3 '20 mm' at 24,10 left textcolor rgb BLACK front
set label 4 'rigid, radius 60 mm' at 0,-9 center textcolor rgb BLACK front
set label 5 'glued' at -21,21 right textcolor rgb BLACK front
plot data.'/fig_1_1_obstacle.csv' using 'x':'y' with filledcurves y1=-12.5 lc rgb LIGHT, \
     '' using 'x':'y' with lines ls 7, \
     data.'/fig_1_1.csv' using 'x':'y' with lines ls 1 lw 1.4, \
     data.'/fig_1_1_nodes.csv' using 'x':'y' with points pt 7 ps 1.1 lc rgb BLUE
