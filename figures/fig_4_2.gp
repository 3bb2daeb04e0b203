# Figure 4.2 - moved minima between two half-planes.   In: fig_4_2.csv   Out: fig_4_2.svg
width = 440; height = 430
load 'style.gp'
set size ratio -1
set xrange [-0.8:1.7]
set yrange [-0.6:2.2]
set xlabel '{/:Italic u}_1'
set ylabel '{/:Italic u}_2'
set xtics 0.5; set ytics 0.5
set key top left
set object 1 polygon from 0,0 to -0.8,0 to -0.8,-0.6 to -0.6,-0.6 to 0,0 fc rgb LIGHT fs solid noborder behind
set label 1 'feasible' at -0.76,-0.13 left
set label 2 '{/:Italic u}^0' at 1.05,2.05 left
set label 3 '{/:Italic u}^1' at 1.03,-0.1 left
set label 4 '{/:Italic u}^2' at 0.44,0.6 right
set label 5 '{/:Italic u}^3' at 0.5,-0.1 center
set label 6 '{/:Italic u}^4' at 0.2,0.34 right
set label 7 'row 1' at 1.68,0.09 right
set label 8 'row 2' at 1.38,1.55 right
plot 0 with lines ls 8 notitle, x with lines ls 8 notitle, \
     data.'/fig_4_2.csv' using 'x':'y' with linespoints ls 1 title 'moved minima', \
     '+' using (0):(0) every ::::0 with points pt 6 ps 1.6 lc rgb RED lw 2 title 'the solution'
