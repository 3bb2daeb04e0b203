# Figure 5.2 - counts against the number of pairs.   In: fig_5_2.csv, fig_5_2_punch.csv   Out: fig_5_2.svg
height = 440
load 'style.gp'
eval LOGLOG
set multiplot
set format xy '%.0f'
set xlabel 'pairs'
set xrange [20:500]
set yrange [0.8:600]
set xtics (25, 50, 100, 200, 400)
set ytics (1, 10, 100)
unset mxtics
set tmargin at screen 0.8
set bmargin at screen 0.19
set lmargin at screen 0.125
set rmargin at screen 0.52
set key at screen 0.98,0.98 maxrows 2 width 1
set label 1 'random, 50 unknowns' at graph 0.05,0.93
set ylabel 'count' offset 1,0
file = data.'/fig_5_2.csv'
plot file using 'pairs':'lemke' with linespoints ls 7 title 'Lemke: pivots', \
     '' using 'pairs':'goldfarb_idnani' with linespoints ls 2 title 'Goldfarb-Idnani: steps', \
     '' using 'pairs':'steps' with linespoints ls 1 title 'ours: steps', \
     '' using 'pairs':'factorisations' with points ls 7 pt 6 ps 1.5 title 'ours: factorisations'
set lmargin at screen 0.58
set rmargin at screen 0.98
set label 1 'punch on a half-plane'
set format y ''
unset ylabel
file = data.'/fig_5_2_punch.csv'
plot file using 'pairs':'lemke' with linespoints ls 7 notitle, \
     '' using 'pairs':'goldfarb_idnani' with linespoints ls 2 notitle, \
     '' using 'pairs':'steps' with linespoints ls 1 notitle, \
     '' using 'pairs':'factorisations' with points ls 7 pt 6 ps 1.5 notitle
unset multiplot
