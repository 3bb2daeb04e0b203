# Figure 1.5 - the block pressed onto the obstacle, with the pressure on it; below, gap and pressure along its base.
# In: fig_1_5.csv, fig_1_5_block.csv, fig_1_5_arrows.csv, fig_1_5_obstacle.csv   Out: fig_1_5.svg
height = 660
load 'style.gp'
load 'bodies.gp'
unset key
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.86
set xrange [-22:22]

set tmargin at screen 1
set bmargin at screen 0.45
unset border; unset tics; unset grid
set yrange [-9:21.5]
set size ratio -1
set object 1 rectangle from -20,19 to 20,21 fillstyle pattern 4 border lc rgb BLACK fillcolor rgb BLACK
set label 1 'rigid' at -13,-8 center front
set label 2 '0.84 N/mm²' at 0,-8.3 center front textcolor rgb RED
eval "plot data.'/fig_1_5_obstacle.csv' using 'x':'y' with filledcurves y1=-10 lc rgb LIGHT, '' using 'x':'y' with lines ls 7, ".body(data.'/fig_1_5_block.csv', 1).', '.pressing(data.'/fig_1_5_arrows.csv', 8, 1)
unset object; unset label
set size noratio

set tmargin at screen 0.40
set bmargin at screen 0.13
set border 11 back ls 100
set xtics 10 nomirror out scale 0.6
set xlabel 'position {/:Italic x} [mm]'
set ylabel 'pressure [N/mm²]' offset 1.8,0
set y2label 'gap [mm]'
set yrange [0:1.2]
set y2range [0:3]
set ytics 0.4 nomirror out scale 0.6
set y2tics 1 out scale 0.6
set label 3 'pressure' at 6,0.75 left
set label 4 'gap' at 14,0.45 right
plot data.'/fig_1_5.csv' using 'x':'pressure' with lines ls 1 lc rgb RED, \
     '' using 'x':'gap' axes x1y2 with lines ls 2 lc rgb BLUE
unset multiplot
