# Figure 22.2 - how far each iteration moves a node: of the frozen loop for four depths of the block, and where forces turn.
# In: fig_22_2.csv   Out: fig_22_2.svg
load 'style.gp'
eval LOGY
file = data.'/fig_22_2.csv'
set xlabel 'iteration'
set ylabel 'largest move [mm]' offset 1,0
set xrange [1:19]
set xtics 4
set yrange [1e-12:1]
set ytics 1e-12,1e3
set key top right Left reverse
frozen(d) = abs(column('depth') - d) < 1e-9 && column('corrections') == 0 ? column('move') : NaN
turned(n) = column('corrections') == n ? column('move') : NaN
plot file using 'iteration':(frozen(0.05)) with linespoints ls 1 title '5 % deep', \
     '' using 'iteration':(frozen(0.02)) with linespoints ls 2 title '2 %', \
     '' using 'iteration':(frozen(0.005)) with linespoints ls 3 title '0.5 %', \
     '' using 'iteration':(frozen(0.001)) with linespoints ls 4 title '0.1 %', \
     '' using 'iteration':(turned(1)) with linespoints ls 5 title '5 %, corrected', \
     '' using 'iteration':(turned(6)) with linespoints ls 6 title '5 %, 6 times'
