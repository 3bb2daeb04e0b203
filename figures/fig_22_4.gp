# Figure 22.4 - ironing: the forces on the die along its path, and the moves of the iterations of one step.
# In: fig_22_4.csv, fig_22_4_moves.csv   Out: fig_22_4.svg
width = 640; height = 640
load 'style.gp'
path = data.'/fig_22_4.csv'
moves = data.'/fig_22_4_moves.csv'
of(kind, name) = column('gaps') == kind ? column(name) : NaN
set multiplot
set lmargin at screen 0.13; set rmargin at screen 0.97
set tmargin at screen 0.985; set bmargin at screen 0.83
set xrange [0:1]
set format x ''
set ylabel 'press [N]'
set yrange [85:95]
set ytics 5
unset key
plot path using 'way':(of(0, 'press')) with lines ls 2, \
     '' using 'way':(of(1, 'press')) with lines ls 1
set tmargin at screen 0.80; set bmargin at screen 0.56
set format x '%g'
set xlabel 'way of the die [mm]'
set ylabel 'drag [N]'
set yrange [24:29]
set ytics 1
plot path using 'way':(of(0, 'drag')) with lines ls 2, \
     '' using 'way':(of(1, 'drag')) with lines ls 1
set tmargin at screen 0.42; set bmargin at screen 0.11
eval LOGY
set xrange [1:40]
set xtics (1, 10, 20, 30, 40)
set yrange [1e-12:1]
set ytics 1e-12,1e3
set xlabel 'iteration of one step'
set ylabel 'largest move [mm]'
set key at 39,1e-7 right Left reverse
plot moves using 'iteration':(of(0, 'move')) with linespoints ls 2 title 'gaps of nodes', \
     '' using 'iteration':(of(1, 'move')) with linespoints ls 1 title 'weighted gaps'
unset multiplot
