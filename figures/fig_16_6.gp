# Figure 16.6 - three knobs: points of the gap, sweeps of a solver, and digits.
# In: fig_16_6.csv, fig_16_6_sweeps.csv, fig_16_6_digits.csv   Out: fig_16_6.svg
width = 900; height = 420
load 'style.gp'
set multiplot
set logscale y
set format y '10^{%T}'
set lmargin at screen 0.09
set rmargin at screen 0.31
set bmargin at screen 0.3
set tmargin at screen 0.82
set xrange [0.5:10.5]
set yrange [0.02:200]
set ytics 0.1, 10, 10
set xtics 2,2,10
set xlabel 'Gauss points'
set title 'error [%]'
set key at graph 1,1 top right noopaque
plot data.'/fig_16_6.csv' using 'points':'edges' with linespoints ls 2 title 'edges', '' using 'points':'segments' with linespoints ls 1 title 'segments'
set lmargin at screen 0.42
set rmargin at screen 0.65
set logscale x
set xrange [0.8:320]
set xtics (1,4,16,64,256)
set yrange [1e-20:1e4]
set ytics 1e-12, 1e4, 1e4
set xlabel 'sweeps'
set title 'error [%]'
set key at graph 0,0.56 left top noopaque
plot data.'/fig_16_6_sweeps.csv' using 'sweeps':'error' with linespoints ls 1 title 'all', '' using 'sweeps':'of_solver' with linespoints ls 2 title 'sweeps', '' using 'sweeps':'of_mesh' with lines ls 8 title 'mesh'
set lmargin at screen 0.75
set rmargin at screen 0.985
set xrange [8:200]
set xtics (10,20,40,80,160)
set yrange [1e-18:1e8]
set ytics 1e-16, 1e4, 1e-4
set xlabel 'length / height'
set title 'certificate'
set key at graph 0.02,1 left top noopaque
plot data.'/fig_16_6_digits.csv' using 'slender':'doubles ≈' with linespoints ls 2 title 'plain', '' using 'slender':'refined ≈' with linespoints ls 1 title 'refined'
unset multiplot
