# Figure 1.2 - the gap formula (2), printed and repaired.   In: fig_1_2.csv   Out: fig_1_2.svg
load 'style.gp'
set xlabel 'slope angle of the obstacle [degrees]'
set ylabel 'gap of a point 1 mm away [mm]'
set xrange [0:60]
set yrange [0:1.2]
set key bottom left
plot 1 with lines ls 7 title 'true distance', \
     data.'/fig_1_2.csv' using 'angle':'repaired' with linespoints ls 1 title 'one division by the root', \
     '' using 'angle':'printed' with linespoints ls 2 title 'as printed: two divisions'
