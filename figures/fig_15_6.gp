# Figure 15.6 - the square: how far its lower side has moved, and what it does there.   In: fig_15_6.csv   Out: fig_15_6.svg
width = 640; height = 360
load 'style.gp'
set xrange [-1:41]; set yrange [-0.1:3.2]
set xlabel 'distance from the free side [mm]'
set ylabel 'moved towards the middle [10^{-2} mm]'
set key top right
file = data.'/fig_15_6.csv'
is(name) = strcol('motion') eq name ? column('moved') : NaN
$published << EOD
0,2.86
1.25,2.72
5,2.28
7.5,1.98
11.25,1.50
EOD
plot file using 'x':(is('open')) with points pt 6 ps 1 lw 1.5 lc rgb GREEN title 'open', \
     file using 'x':(is('forward')) with points pt 9 ps 0.9 lc rgb RED title 'slides', \
     file using 'x':(is('stick')) with points pt 5 ps 0.8 lc rgb BLUE title 'sticks', \
     $published using 1:2 with points pt 2 ps 1.6 lw 1.5 lc rgb BLACK title 'published'
