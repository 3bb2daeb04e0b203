# Figure 22.8 - the forces on the die along its way through the slab.   In: fig_22_8.csv   Out: fig_22_8.svg
load 'style.gp'
file = data.'/fig_22_8.csv'
set xlabel 'way of the die along the slab'
set ylabel 'force / ({/:Italic E} · length)' offset 1,0
set xrange [0:4]
set yrange [0:0.45]
set key at 3.9,0.3 right Left reverse
plot file using 'way':'press' with lines ls 1 title 'press', \
     '' using 'way':'drag' with lines ls 2 title 'drag'
