# Figure 15.3 - what sticks and what slides, over place and push.
# In: fig_15_3.csv, fig_15_3_edge.csv   Out: fig_15_3.svg
width = 640; height = 440
load 'style.gp'
set xrange [-1:1]; set yrange [1:6.05]
set xtics 0.25
set xlabel '{/:Italic x} [mm]'
set ylabel 'push {/:Italic Q} / {/:Italic μP}, time upwards'
set ytics ('0' 1, '0.6' 2, '0' 3, '−0.6' 4, '0' 5, '0.6' 6)
set key off
set grid noxtics noytics
set style fill solid 1.0 noborder
file = data.'/fig_15_3.csv'
is(name) = strcol('motion') eq name ? column('x') : NaN
do for [t=1:6] { set arrow from -1,t to 1,t nohead lw 0.6 lc rgb GREY front }
set label 'sticks' at 0,3.4 center front textcolor rgb '#ffffff'
set label 'sticks' at 0,5.4 center front textcolor rgb '#ffffff'
set label 'forth' at 0.7,1.76 center front textcolor rgb BLACK
set label 'forth' at -0.7,1.76 center front textcolor rgb BLACK
set label 'back' at 0.68,3.7 center front textcolor rgb BLACK
set label 'back' at -0.68,3.7 center front textcolor rgb BLACK
set label 'forth' at 0.68,5.7 center front textcolor rgb BLACK
set label 'forth' at -0.68,5.7 center front textcolor rgb BLACK
set label 'open' at 0.89,2.9 center front textcolor rgb BLACK
set label 'open' at -0.89,2.9 center front textcolor rgb BLACK
half = 1.0/12
plot file using (is('stick')):'time':(column('x')-column('width')/2):(column('x')+column('width')/2):(column('time')-2*half):(column('time')) with boxxyerror fc rgb BLUE, \
     file using (is('forward')):'time':(column('x')-column('width')/2):(column('x')+column('width')/2):(column('time')-2*half):(column('time')) with boxxyerror fc rgb ORANGE, \
     file using (is('backward')):'time':(column('x')-column('width')/2):(column('x')+column('width')/2):(column('time')-2*half):(column('time')) with boxxyerror fc rgb LIGHT, \
     data.'/fig_15_3_edge.csv' using 'stuck':'time' with lines ls 7 lw 2, \
     '' using (-column('stuck')):'time' with lines ls 7 lw 2
