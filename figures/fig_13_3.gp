# Figure 13.3 - how far the soil must reach and how thick the footing must be.
# In: fig_13_3.csv, fig_13_3_plate.csv, fig_13_3_thickness.csv   Out: fig_13_3.svg
width = 900; height = 400
load 'style.gp'
set multiplot layout 1,2
set lmargin 9
set rmargin 8
set logscale x 2
set xrange [2.7:44]
set xtics (3, 5, 10, 20, 40)
set xlabel 'width and depth of the soil / {/:Italic a}'
set ylabel '{/:Italic p}(0) more than (46) [%]'
set yrange [-0.5:8]
set y2range [0:8]
set y2tics 1
set y2label 'settlement [mm]' offset -1,0
set key top right
plot data.'/fig_13_3.csv' using 'size':'pressure' with points ls 1 title 'pressure', \
     65/x**2 with lines ls 7 title '65 (a/H)²', \
     '' using 'size':'settlement' axes x1y2 with linespoints ls 2 title 'settlement'
unset y2tics; unset y2label; unset logscale
set rmargin 4
set key bottom left
set logscale xy
set xrange [0.06:2.2]
set xtics (0.1, 0.2, 0.5, 1, 2)
set yrange [0.02:100]
set ytics ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set xlabel 'thickness of the footing [m]'
set ylabel '{/:Italic p}(0) more than under a rigid footing [%]'
plot data.'/fig_13_3_thickness.csv' using 'thickness':'pressure' with linespoints ls 1 title 'elastic body', \
     data.'/fig_13_3_plate.csv' using 'thickness':'pressure' with points ls 7 ps 1.2 title 'plate on a half-plane'
unset multiplot
