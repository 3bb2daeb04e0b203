# Figure 13.2 - pressure under the footing, and the forces of the nodes against (46).
# In: fig_13_2.csv, fig_13_2_142.csv   Out: fig_13_2.svg
width = 640; height = 680
load 'style.gp'
set multiplot layout 2,1
set xrange [0:1.53]
set xlabel 'position {/:Italic x} [m]'
set ylabel 'force over length / {/:Italic q}'
set yrange [0:6.3]
set key top left
plot data.'/fig_13_2.csv' using 'x':'pressure' with points ls 1 pt 6 ps 0.6 title '9948 nodes', \
     data.'/fig_13_2_142.csv' using 'x':'pressure' with points ls 2 ps 1 title '142 nodes', \
     (x < 1.5 ? 2/(pi*sqrt(1 - (x/1.5)**2)) : NaN) with lines ls 7 title '(46)'
set xlabel 'distance from the edge {/:Italic a − x} [m]'
set logscale x
set xrange [1.6:2e-4]
set xtics (1, 0.1, 0.01, 0.001)
set ylabel 'more than (46) [%]'
set yrange [-10:20]
set ytics 10
set arrow 1 from 0.3,-10 to 0.3,20 nohead ls 8
set label 1 '{/:Italic x} = 0.8 {/:Italic a}' at 0.28,12 left
plot data.'/fig_13_2.csv' using 'from_edge':'deviation' with linespoints ls 1 pt 6 ps 0.6 notitle, \
     data.'/fig_13_2_142.csv' using 'from_edge':'deviation' with linespoints ls 2 ps 1 notitle
unset multiplot
