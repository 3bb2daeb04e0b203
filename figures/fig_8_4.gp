# Figure 8.4 - residual and error in three systems of units, and with scaled forces.   In: fig_8_4.csv   Out: fig_8_4.svg
width = 640
height = 430
load 'style.gp'
eval LOGY
file = data.'/fig_8_4.csv'
set xrange [0:16.5]
set xlabel 'step'
set yrange [1e-16:1e2]
set ytics 1e-16, 1e4
set lmargin 8
set rmargin 2
unset key
set multiplot layout 1,2
set title 'largest |φ|'
set label 1 'mm, MPa' at 7.3,3e-2 left
set label 2 'm, MPa' at 7.6,1e-14 right
set label 3 'm, GPa' at 14.2,1e-7 right
plot 1e-8 with lines ls 8, \
     file using 'step':'residual' every :::0::0 with linespoints ls 1, \
     file using 'step':'residual' every :::2::2 with linespoints ls 2, \
     file using 'step':'residual' every :::4::4 with linespoints ls 3
set title 'error of the forces'
set label 1 at 11.2,1e-12 left
set label 2 at 6.4,1e-7 right
set label 3 at 14.2,8 right
set label 4 'scaled' at 8.4,3e-14 right
set arrow 1 from 6.5,1e-7 to 7.8,6e-7 nohead lc rgb BLACK lw 1 dt 1
set arrow 2 from 11,1e-12 to 10.6,1e-12 nohead lc rgb BLACK lw 1 dt 1
plot file using 'step':'error' every :::0::0 with linespoints ls 1, \
     file using 'step':'error' every :::2::2 with linespoints ls 2, \
     file using 'step':'error' every :::4::4 with linespoints ls 3, \
     file using 'step':'error' every :::1::1 with linespoints ls 7 lw 2, \
     file using 'step':'error' every ::10:0:10:0 with points pt 6 ps 2 lw 2 lc rgb BLACK, \
     file using 'step':'error' every ::7:2:7:2 with points pt 6 ps 2 lw 2 lc rgb BLACK, \
     file using 'step':'error' every ::4:4:4:4 with points pt 6 ps 2 lw 2 lc rgb BLACK
unset multiplot
