# Figure 5.3 - pivots on Fathi's problems.   In: fig_5_3.csv   Out: fig_5_3.svg
height = 480
load 'style.gp'
set logscale y 2
set format y '%.0f'
set xlabel 'number of pairs {/:Italic n_c}'
set ylabel 'pivots or steps'
set xrange [1.8:10.2]
set yrange [0.7:2000]
set ytics (1, 4, 16, 64, 256, 1024)
set xtics 1
set tmargin 6.5
set key at graph 0,1.03 bottom left
file = data.'/fig_5_3.csv'
plot 2**x with lines ls 8 title '2^{n_c}, all bases', \
     file using 'n':'lemke' with points ls 7 title 'Lemke, covering vector of ones', \
     '' using 'n':'scaled' with linespoints ls 2 title 'Lemke, rows scaled first', \
     '' using 'n':'steps' with linespoints ls 1 title 'ours'
