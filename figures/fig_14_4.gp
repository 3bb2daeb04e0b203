# Figure 14.4 - stresses through both walls.   In: fig_14_4.csv, fig_14_4_cells.csv   Out: fig_14_4.svg
height = 560
load 'style.gp'
set multiplot layout 2,1
set xrange [59.5:76.7]
set ylabel 'hoop stress [MPa]'
set yrange [0:1200]
set ytics 300
set label 1 'lining' at 64,830 center
set label 2 'rock' at 72,470 center
plot data.'/fig_14_4.csv' using 'r':'hoop' with lines ls 7 title 'closed form', \
     data.'/fig_14_4_cells.csv' using 'r':'hoop' with points ls 1 ps 0.9 title 'cells, 120 nodes'
unset label
set xlabel 'radius {/:Italic r} [cm]'
set ylabel 'radial stress [MPa]'
set yrange [-200:0]
set ytics 50
unset key
plot data.'/fig_14_4.csv' using 'r':'radial' with lines ls 7, \
     data.'/fig_14_4_cells.csv' using 'r':'radial' with points ls 1 ps 0.9
unset multiplot
