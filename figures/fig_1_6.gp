# Figure 1.6 - the nearest admissible displacement of two carts, in energy.
# In: fig_1_6.csv, fig_1_6_set.csv, fig_1_6_points.csv   Out: fig_1_6.svg
height = 520
load 'style.gp'
unset key
set size ratio -1
set xrange [0:6.2]
set yrange [0:9]
set lmargin 8
set xlabel 'first cart [mm]'
set ylabel 'second cart [mm]'
points = data.'/fig_1_6_points.csv'
set label 1 'u^0' at 3.15,6.2 textcolor rgb BLACK front
set label 2 'u' at 1.6,3.05 textcolor rgb RED front
set label 3 'corner' at 2.8,3.2 textcolor rgb BLACK front
set label 4 'admissible' at 0.4,1.6 textcolor rgb BLACK front
plot data.'/fig_1_6_set.csv' using 'x':'y' with filledcurves closed fc rgb '#dcebf5', \
     '' using 'x':'y' with lines ls 7, \
     data.'/fig_1_6.csv' using 'x':'y' with lines ls 1, \
     points using 'x':'y' every ::0::1 with lines ls 8, \
     points using 'x':'y' every ::0::0 with points pt 6 ps 1.1 lw 2 lc rgb BLACK, \
     points using 'x':'y' every ::1::1 with points pt 7 ps 1.2 lc rgb RED, \
     points using 'x':'y' every ::2::2 with points pt 4 ps 1.1 lw 2 lc rgb BLACK
