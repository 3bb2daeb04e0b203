# Figure 13.4 - how far the soil must reach and how thick the footing must be.
# In: fig_13_4.csv, fig_13_4_plate.csv, fig_13_4_thickness.csv   Out: fig_13_4.svg
width = 640; height = 680
load 'style.gp'
set multiplot layout 2,1
set logscale x 2
set xrange [2.7:44]
set xtics (3, 5, 10, 20, 40)
set xlabel 'width and depth of the soil / {/:Italic a}'
set ylabel '{/:Italic p}(0) more than (46) [%]'
set yrange [-0.5:8]
set key top right
plot data.'/fig_13_4.csv' using 'size':'pressure' with points ls 1 ps 1 title 'mesh', \
     65/x**2 with lines ls 7 title '65 (a/H)²'
unset logscale
set key bottom left
set logscale xy
set xrange [0.06:2.2]
set xtics (0.1, 0.2, 0.5, 1, 2)
set yrange [0.02:100]
set ytics ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set xlabel 'thickness of the footing [m]'
set ylabel '{/:Italic p}(0) more than rigid [%]'
plot data.'/fig_13_4_thickness.csv' using 'thickness':'pressure' with linespoints ls 1 ps 1 title 'elastic body', \
     data.'/fig_13_4_plate.csv' using 'thickness':'pressure' with points ls 7 ps 1.4 title 'plate on a half-plane'
unset multiplot
