# Figure 6.3 - the deformed beam with its bending stress.   In: fig_6_3.csv   Out: fig_6_3.svg
width = 760; height = 230
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [cm]'
set ylabel '{/:Italic y} [cm]'
set xrange [0:50.5]
set yrange [-2.2:6]
set ytics 2
set rmargin 14
set palette maxcolors 12
set cblabel 'σ_{xx} [kN/cm²]' offset 1,0
set cbtics 100
set object 1 rectangle from 0,-2.2 to 50.5,-1 fc rgb LIGHT fs solid noborder behind
plot data.'/fig_6_3.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1
