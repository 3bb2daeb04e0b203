# Figure 2.2 - s over the triangle of weights, and its top.
# In: fig_2_2.csv, fig_2_2_path.csv, fig_2_2_best.csv, fig_2_2_top.csv   Out: fig_2_2.svg
height = 1000
load 'style.gp'
unset grid
unset border
unset tics
set lmargin 2
set rmargin 2
set contour base
set cntrparam points 5
unset surface
set cntrparam levels discrete 0.5,1,2,3,4,5,6,7
set table $lines
splot data.'/fig_2_2.csv' using 'x':'y':'s' with lines
set cntrparam levels discrete 6.6,6.8,7,7.05,7.08
set table $near
splot data.'/fig_2_2_top.csv' using 'x':'y':'s' with lines
unset contour
set surface
set table $path
plot data.'/fig_2_2_path.csv' using 'x':'y' with table
set table $best
plot data.'/fig_2_2_best.csv' using 'x':'y' with table
unset table
set datafile separator whitespace
set multiplot
set size ratio -1 1,0.6
set origin 0,0.4
set xrange [-0.12:1.12]
set yrange [-0.1:1.08]
set label 1 '1: left' at -0.01,-0.05 center
set label 2 '2: middle' at 1.0,-0.05 center
set label 3 '3: right' at 0.5,0.91 center
set object 1 polygon from 0,0 to 1,0 to 0.5,0.8660254 to 0,0 fillstyle empty border lc rgb BLACK lw 1.5
set object 2 rectangle from 0.66,0.13 to 0.84,0.26 fillstyle empty border lc rgb BLACK lw 1 dt 1
set key at screen 0.98,0.99 maxrows 2
plot $lines using 1:2 with lines ls 8 dt 1 title 'lines of equal {/:Italic s}', \
     $lines using ($2 < 0.8 ? $1 : NaN):2:(sprintf('%g',$3)) every 1000::12 with labels textcolor rgb BLACK @HALO notitle, \
     $path using 1:2 with linespoints ls 2 title 'line search', \
     $path using 1:2 every ::0::0 with points pt 6 ps 1.6 lw 2 lc rgb BLACK title 'start: each a third', \
     $best using 1:2 with points pt 3 ps 1.8 lw 2 lc rgb BLUE title 'forces over their sum'
unset label
unset object
set size ratio -1 1,0.4
set origin 0,0
set xrange [0.66:0.84]
set yrange [0.13:0.26]
set border 15 back ls 100
plot $near using 1:2 with lines ls 8 dt 1 notitle, \
     $near using ($1 < 0.83 ? $1 : NaN):2:(sprintf('%g',$3)) every 1000::50 with labels textcolor rgb BLACK @HALO notitle, \
     $path using 1:2 with linespoints ls 2 ps 1 notitle, \
     $best using 1:2 with points pt 3 ps 2.2 lw 2 lc rgb BLUE notitle
unset multiplot
