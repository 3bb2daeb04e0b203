# Figure 20.1 - the cantilever by exchanges of one pair: its load at once, and in increments.
# In: fig_20_1.csv, fig_20_1_increments.csv   Out: fig_20_1.svg
width = 860; height = 430
load 'style.gp'
set multiplot
set tmargin at screen 0.85; set bmargin at screen 0.26
set title 'the load at once'
set lmargin at screen 0.11; set rmargin at screen 0.46
set xlabel 'exchanges'
set logscale y
set yrange [1e-8:30]
set ytics ('10^{-8}' 1e-8, '10^{-6}' 1e-6, '10^{-4}' 1e-4, '0.01' 0.01, '1' 1, '17' 17)
set xrange [0:90]
set xtics 20
set key bottom left noopaque samplen 1.8
plot data.'/fig_20_1.csv' using 'pivot':'overlaps' with lines ls 1 title 'overlaps / first', \
     '' using (column('pivot')):(column('closed') > 0 ? column('closed') : NaN) with lines ls 2 title 'forces'
set title 'in increments'
set lmargin at screen 0.60; set rmargin at screen 0.97
set xlabel 'increments'
set logscale x
set autoscale y
unset logscale y
set yrange [0:175]
set ytics 40
set xrange [0.8:260]
set xtics (1,2,5,10,20,50,200)
set key top right noopaque
plot data.'/fig_20_1_increments.csv' using 'increments':'pivots' with linespoints ls 1 title 'exchanges', \
     17 with lines ls 8 title 'closed pairs'
unset multiplot
