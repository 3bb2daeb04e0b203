# Figure 7.3 - a pin in an infinite plate.   In: fig_7_3.csv   Out: fig_7_3.svg
load 'style.gp'
set xlabel 'angle from the pole {/:Italic θ} [deg]'
set ylabel 'contact pressure {/:Italic p a} / {/:Italic P}'
set xrange [0:75]
set yrange [0:1.2]
set xtics 15
plot data.'/fig_7_3.csv' using 'theta':'closed' every :::0::0 with lines ls 7 title 'closed form', \
     '' using 'theta':'closed' every :::1::1 with lines ls 7 notitle, \
     '' using 'theta':'fe' every 2:::0::0 with points ls 1 title 'disc of 60 radii, shift 2 clearances', \
     '' using 'theta':'fe' every 2:::1::1 with points ls 2 title 'disc of 60 radii, shift 5 clearances'
