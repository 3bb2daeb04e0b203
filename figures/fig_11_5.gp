# Figure 11.5 - the two surfaces at the contact, before and after loading, and the two nodes that touch first.
# In: fig_11_5.csv   Out: fig_11_5.svg
width = 860; height = 440
load 'style.gp'
set multiplot
set xlabel '{/:Italic x} [mm]'
set tmargin at screen 0.86; set bmargin at screen 0.25
set lmargin at screen 0.11; set rmargin at screen 0.60
set title 'both surfaces'
set ylabel 'height [µm]' offset 1,0
set xrange [-0.06:2]
set yrange [-36:85]
set xtics 0.5
set ytics 20
set key top left noopaque samplen 1.8
set object 1 rectangle from -0.045,-30.4 to 0.1,-28 fc rgb RED fs empty border rgb RED lw 1.4 front
plot data.'/fig_11_5.csv' using 'x':'y' every :::0::0 with lines ls 2 title 'disc, before', \
     '' using 'x':'y' every :::1::1 with lines ls 8 title 'plate, before', \
     '' using 'x_moved':'y_moved' every :::0::0 with linespoints ls 1 pt 7 ps 0.5 title 'disc, loaded', \
     '' using 'x_moved':'y_moved' every :::1::1 with linespoints ls 7 pt 6 ps 0.9 lw 1 title 'plate, loaded'
unset object 1
set title 'the two nodes'
unset ylabel
set lmargin at screen 0.70; set rmargin at screen 0.98
set xrange [-0.01:0.1]
set yrange [-30:-28.6]
set xtics 0.05
set ytics 0.5
unset key
set label 1 'ABAQUS, plate' at 0.008,-28.84 left
set label 2 'ABAQUS, disc' at 0.008,-29.24 left
set label 3 'ours, both' at 0.012,-29.74 left
plot data.'/fig_11_5.csv' using 'x_moved':'y_moved' every :::0::0 with linespoints ls 1 pt 7 ps 0.8, \
     '' using 'x_moved':'y_moved' every :::1::1 with linespoints ls 7 pt 6 ps 1.5, \
     '+' using (0):(-29.3163) every ::0::0 with points pt 7 ps 1 lc rgb RED, \
     '+' using (0):(-28.9943) every ::0::0 with points pt 6 ps 1.3 lw 1.5 lc rgb RED
unset multiplot
