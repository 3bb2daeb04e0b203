# Figure 7.5 - a pin in an infinite plate.   In: fig_7_5.csv   Out: fig_7_5.svg
width = 480; height = 360
load 'style.gp'
set lmargin 8.5
set xlabel 'angle from the pole {/:Italic θ} [deg]'
set ylabel 'contact pressure {/:Italic p a} / {/:Italic P}' offset 0.5,0
set xrange [0:75]
set yrange [0:1.2]
set key noopaque
set xtics 15
plot data.'/fig_7_5.csv' using 'theta':'closed' every :::0::0 with lines ls 7 title 'closed form', \
     '' using 'theta':'closed' every :::1::1 with lines ls 7 notitle, \
     '' using 'theta':'fe' every 2:::0::0 with points ls 1 title 'disc, shift 2 clearances', \
     '' using 'theta':'fe' every 2:::1::1 with points ls 2 title 'disc, shift 5 clearances'
