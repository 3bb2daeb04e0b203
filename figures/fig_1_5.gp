# Figure 1.5 - gap and pressure along the base of the block.   In: fig_1_5.csv, fig_1_5_obstacle.csv   Out: fig_1_5.svg
height = 640
load 'style.gp'
set multiplot layout 2,1
set xrange [-20:20]
set lmargin 11
set rmargin 11
set ylabel 'height [mm]'
set yrange [-3.6:0.6]
set ytics 1
set key bottom center
plot data.'/fig_1_5_obstacle.csv' using 'x':'obstacle' with filledcurves y1=-3.6 lc rgb LIGHT title 'rigid obstacle', \
     '' using 'base_x':'base_y' with lines ls 1 title 'base of the block', \
     '' using 'x':'obstacle' with lines ls 7 lw 1 notitle
set xlabel 'position {/:Italic x} [mm]'
set ylabel 'contact pressure [N/mm²]'
set y2label 'gap [mm]'
set yrange [0:1.6]
set y2range [0:4]
set ytics nomirror 0.4
set y2tics 1
set border 11 back ls 100
set key top center
plot data.'/fig_1_5.csv' using 'x':'pressure' with lines ls 1 title 'pressure', \
     '' using 'x':'gap' axes x1y2 with lines ls 2 title 'gap'
unset multiplot
