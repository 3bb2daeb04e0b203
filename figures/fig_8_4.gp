# Figure 8.4 - residual and error in three systems of units, and with scaled forces.   In: fig_8_4.csv   Out: fig_8_4.svg
width = 640
height = 540
load 'style.gp'
eval LOGY
file = data.'/fig_8_4.csv'
set xrange [0:14.5]
set xlabel 'step'
set yrange [1e-16:1e8]
set ytics 1e-16, 1e4
set lmargin 8
set rmargin 2
set multiplot layout 1,2
set tmargin at screen 0.72
set title 'largest |φ|'
set key at screen 0.5,0.99 top right
plot 1e-8 with lines ls 8 notitle, \
     file using 'step':'residual' every :::0::0 with linespoints ls 1 title 'mm, MPa', \
     file using 'step':'residual' every :::2::2 with linespoints ls 2 title 'm, MPa', \
     file using 'step':'residual' every :::4::4 with linespoints ls 3 title 'm, GPa'
set title 'error of the forces'
set key at screen 0.99,0.99 top right width -3
plot file using 'step':'error' every :::0::0 with linespoints ls 1 notitle, \
     file using 'step':'error' every :::2::2 with linespoints ls 2 notitle, \
     file using 'step':'error' every :::4::4 with linespoints ls 3 notitle, \
     file using 'step':'error' every :::1::1 with linespoints ls 7 lw 2 title 'scaled: all of them', \
     file using 'step':'error' every ::10:0:10:0 with points pt 6 ps 2 lw 2 lc rgb BLACK title 'where |φ| ≤ 10^{−8} ends', \
     file using 'step':'error' every ::7:2:7:2 with points pt 6 ps 2 lw 2 lc rgb BLACK notitle, \
     file using 'step':'error' every ::4:4:4:4 with points pt 6 ps 2 lw 2 lc rgb BLACK notitle
unset multiplot
