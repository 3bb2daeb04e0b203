# Figure 10.4 - error of nodal pressures against the number of Gauss points.   In: fig_10_4.csv, fig_10_4_segments.csv
# Out: fig_10_4.svg
width = 640
height = 460
load 'style.gp'
eval LOGLOG
file = data.'/fig_10_4.csv'
set xrange [1.8:18]
set xtics (2, 3, 4, 6, 8, 10, 13, 16)
set format x '%g'
set grid noxtics nomxtics
set yrange [0.03:10]
set ytics ('0.03' 0.03, '0.1' 0.1, '0.3' 0.3, '1' 1, '3' 3, '10' 10)
set xlabel 'Gauss points on an edge of the source'
set ylabel 'error of the pressure [%]'
set lmargin 11
plot 3.2 * (2 / x)**2 with lines ls 8 title 'slope −2', \
     file using 'points':'patch' with linespoints ls 1 title 'blocks, worst node', \
     file using 'points':'disc' with linespoints ls 2 title 'disc, root mean square', \
     data.'/fig_10_4_segments.csv' using 'points':'disc' with lines ls 7 title 'disc, segments'
