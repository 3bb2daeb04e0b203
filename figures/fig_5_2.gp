# Figure 5.2 - counts against the number of pairs.   In: fig_5_2.csv, fig_5_2_punch.csv   Out: fig_5_2.svg
width = 760
height = 420
load 'style.gp'
eval LOGLOG
set multiplot layout 1,2
set format xy '%.0f'
set xlabel 'pairs'
set xrange [20:500]
set yrange [0.8:1000]
set xtics (25, 50, 100, 200, 400)
set ytics (1, 10, 100, 1000)
unset mxtics
set lmargin 9
set rmargin 2
set key top left
set title 'random, 50 unknowns'
set ylabel 'count'
file = data.'/fig_5_2.csv'
plot file using 'pairs':'lemke' with linespoints ls 7 title 'Lemke: pivots', \
     '' using 'pairs':'goldfarb_idnani' with linespoints ls 2 title 'Goldfarb-Idnani: steps', \
     '' using 'pairs':'steps' with linespoints ls 1 title 'ours: steps', \
     '' using 'pairs':'factorisations' with points ls 7 pt 6 ps 1.5 title 'ours: factorisations'
set title 'punch on a half-plane'
unset ylabel
file = data.'/fig_5_2_punch.csv'
plot file using 'pairs':'lemke' with linespoints ls 7 notitle, \
     '' using 'pairs':'goldfarb_idnani' with linespoints ls 2 notitle, \
     '' using 'pairs':'steps' with linespoints ls 1 notitle, \
     '' using 'pairs':'factorisations' with points ls 7 pt 6 ps 1.5 notitle
unset multiplot
