# Figure 22.2 - how far each iteration of the frozen loop moves a node, for four depths of the block.
# In: fig_22_2.csv   Out: fig_22_2.svg
load 'style.gp'
eval LOGY
file = data.'/fig_22_2.csv'
set xlabel 'iteration'
set ylabel 'largest move [mm]' offset 1,0
set xrange [1:19]
set xtics 2
set yrange [1e-12:1]
set ytics 1e-12,1e3
set key top right Left reverse title 'depth'
depth(d) = abs(column('depth') - d) < 1e-9 ? column('move') : NaN
plot file using 'iteration':(depth(0.05)) with linespoints ls 1 title '5 %', \
     '' using 'iteration':(depth(0.02)) with linespoints ls 2 title '2 %', \
     '' using 'iteration':(depth(0.005)) with linespoints ls 3 title '0.5 %', \
     '' using 'iteration':(depth(0.001)) with linespoints ls 4 title '0.1 %'
