# Figure 9.3 - uniform pressure through node-to-segment contact.   In: fig_9_3.csv   Out: fig_9_3.svg
width = 640
height = 360
load 'style.gp'
file = data.'/fig_9_3.csv'
set xrange [0:2]
set xlabel 'along the interface'
set yrange [-0.1:2.6]
set ytics 0.5
set lmargin 8
set ylabel 'pressure over load' offset 1,0
set rmargin 2
set multiplot layout 1,2
set key top left
set title 'nodes of the source'
plot 1 with lines ls 7 title 'exact', \
     file using 'x':'p' every :::0::0 with linespoints ls 1 title '8 edges over 11', \
     file using 'x':'p' every :::2::2 with linespoints ls 2 title '7 edges over 15'
unset ylabel
set title 'nodes of the target'
plot 1 with lines ls 7 notitle, \
     file using 'x':'p' every :::1::1 with linespoints ls 1 notitle, \
     file using 'x':'p' every :::3::3 with linespoints ls 2 notitle
unset multiplot
