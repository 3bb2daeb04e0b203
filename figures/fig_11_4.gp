# Figure 11.4 - pressures at Gauss points and at nodes.   In: fig_11_4.csv   Out: fig_11_4.svg
height = 400
load 'style.gp'
set xlabel 'distance from the axis {/:Italic x} [mm]'
set ylabel 'pressure {/:Italic p}/{/:Italic q}_0'
set xrange [0:1.25]
set yrange [0:2.4]
set xtics 0.2
set ytics 0.5
unset key
set style arrow 1 nohead lc rgb BLACK lw 1 dt 1
set label 1 'Gauss points, nodes do not meet' at 0.19,2.26 left
set label 2 'Gauss points, nodes meet, J mended' at 1.24,1.74 right
set arrow from 0.77,1.66 to 0.77,1.47 as 1
set arrow from 0.9,1.66 to 0.895,1.45 as 1
set label 3 "closed form,\nnodes on it" at 1.24,1.15 right
set arrow from 1.12,0.9 to 1.055,0.3 as 1
plot data.'/fig_11_4.csv' using 'x':'p' every :::1::1 with linespoints ls 5 lw 1.2, \
     '' using 'x':'p' every :::0::0 with linespoints ls 3 lw 1.2, \
     '' using 'x':'p' every :::3::3 with lines ls 7, \
     '' using 'x':'p' every :::2::2 with points ls 1 ps 1
