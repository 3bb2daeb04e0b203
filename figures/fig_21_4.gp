# Figure 21.4 - a leaf spring: what its pairs cost, counted and in seconds, against no condensing.
# In: fig_21_4.csv   Out: fig_21_4.svg
width = 760; height = 400
load 'style.gp'
set multiplot
set logscale xy
set xrange [100:1600]
set xtics (120, 240, 480, 960)
set tmargin at screen 0.85
set bmargin at screen 0.25
set xlabel 'pairs'
set lmargin at screen 0.09
set rmargin at screen 0.47
set yrange [0.02:1e6]
set format y '%g'
set ytics (0.1, 1, 10, 100)
set title 'operations / plain solve'
set key top left
file = data.'/fig_21_4.csv'
plot 1 with lines ls 8 notitle, \
     file using 'pairs':'factor' with linespoints ls 1 title 'factor of the leaves', \
     '' using 'pairs':'rows' with linespoints ls 3 title 'rows of contact', \
     '' using 'pairs':'dense' with linespoints ls 2 title 'one factor of all pairs'
set lmargin at screen 0.58
set rmargin at screen 0.97
set yrange [0.005:10]
set ytics (0.01, 0.1, 1)
set title 'seconds'
plot file using 'pairs':'condensed ≈' with linespoints ls 2 title 'condensed', \
     '' using 'pairs':'not condensed ≈' with linespoints ls 7 title 'not condensed'
unset multiplot
