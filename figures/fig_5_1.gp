# Figure 5.1 - how far the energies of table 1 are off.   In: fig_5_1.csv   Out: fig_5_1.svg
height = 440
load 'style.gp'
eval LOGY
set xlabel '{/:Italic n} unknowns above {/:Italic m} rows' offset 0,-0.8
set bmargin 5
set ylabel 'relative deviation of the energy'
set xrange [-0.6:11.6]
set yrange [1e-17:1e2]
set ytics 1e-16, 1e2
set key top left
set grid noxtics
set label 1 'rounding of a double' at 11.5, 3.5e-17 right textcolor rgb BLACK
file = data.'/fig_5_1.csv'
plot 2.2e-16 with lines ls 8 notitle, \
     file using 'place':'paper':xtic(sprintf("%d\n%d", column('n'), column('m'))) with linespoints ls 7 title 'paper: |f_P/f_L − 1| as printed', \
     '' using 'place':'ours' with points pt 7 ps 1 lc rgb BLUE title 'ours: |f/f* − 1|, the worst of five'
