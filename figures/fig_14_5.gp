# Figure 14.5 - the rims around the pair of nodes at 40 degrees, before and after.   In: fig_14_5.csv   Out: fig_14_5.svg
height = 480
load 'style.gp'
set size ratio -1
set xlabel '{/:Italic x} [cm]'
set ylabel '{/:Italic y} [cm]'
set xrange [51.8:52.7]
set yrange [43.38:44.05]
set xtics 0.2
set ytics 0.1
set key bottom left noopaque
set arrow 1 from 52.09102,43.70956 to 52.27,43.86 head filled lc rgb GREY lw 1 dt 1 back
set label 1 '10' at 52.06,43.69 right
set label 2 '80' at 52.19,43.81 left offset -3.1,0.4
set label 3 '10 and 80' at 52.33,43.90
plot data.'/fig_14_5.csv' using 'x':'y' every :::0::0 with linespoints ls 1 dt 1 pt 7 ps 1 title 'lining, before', \
     '' using 'x':'y' every :::1::1 with linespoints ls 3 pt 9 ps 1.2 title 'rock, before', \
     '' using 'x_moved':'y_moved' every :::0::0 with linespoints lc rgb '#60E69F00' lw 6 dt 1 pt 7 ps 1.3 title 'lining, loaded', \
     '' using 'x_moved':'y_moved' every :::1::1 with linespoints ls 7 pt 6 ps 1.8 title 'rock, loaded'
