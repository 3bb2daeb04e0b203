# Figure 13.1 - pressure under the footing, and the forces of the nodes against (46).
# In: fig_13_1.csv, fig_13_1_142.csv   Out: fig_13_1.svg
width = 900; height = 400
load 'style.gp'
set multiplot layout 1,2
set xrange [0:1.53]
set xlabel 'position {/:Italic x} [m]'
set ylabel 'force over length / {/:Italic q}'
set yrange [0:6.3]
set key top left
plot data.'/fig_13_1.csv' using 'x':'pressure' with points ls 1 pt 6 ps 0.5 title '9948 nodes', \
     data.'/fig_13_1_142.csv' using 'x':'pressure' with points ls 2 ps 0.9 title '142 nodes', \
     (x < 1.5 ? 2/(pi*sqrt(1 - (x/1.5)**2)) : NaN) with lines ls 7 title '(46)'
set ylabel 'force against its share of (46) [%]'
set yrange [-10:20]
set arrow 1 from 1.2,-10 to 1.2,20 nohead ls 8
set label 1 '0.8 {/:Italic a}' at 1.18,17 right font ',11'
plot data.'/fig_13_1.csv' using 'x':'deviation' with linespoints ls 1 pt 6 ps 0.5 title '9948 nodes', \
     data.'/fig_13_1_142.csv' using 'x':'deviation' with linespoints ls 2 ps 0.9 title '142 nodes'
unset multiplot
