# Figure 3.1 - two pairs: the literal rule hops over the top.   In: fig_3_1.csv   Out: fig_3_1.svg
load 'style.gp'
set xlabel 'weight of the first pair'
set ylabel '{/:Italic s}'
set xrange [-0.03:1.03]
set yrange [0:14]
set key bottom right
set arrow 1 from 0.03,6.6 to 0.96,12.2 size screen 0.02,20 ls 2 dt 1
set arrow 2 from 0.97,11.9 to 0.04,6.2 size screen 0.02,20 ls 2 dt 1
set arrow 3 from 0.53,12.4 to 0.7,13.25 size screen 0.02,20 ls 1 front
plot data.'/fig_3_1.csv' using 'weight':'s' with lines ls 7 title '{/:Italic s}', \
     '' using 'weight':'s' every 100 with points ls 2 ps 1.4 title 'literal rule: there and back', \
     '' using 'weight':'s' every 1000::50 with points pt 6 ps 1.4 lw 2 lc rgb BLACK title 'start', \
     '' using 'weight':'s' every 1000::75 with points pt 3 ps 1.6 lw 2 lc rgb BLUE title 'line search, one step'
