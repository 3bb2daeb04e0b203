# Figure 6.6 - the order of elimination, and what the rows of A meet.   In: fig_6_6.csv, fig_6_6_tree.csv   Out: fig_6_6.svg
width = 480; height = 640
load 'style.gp'
set multiplot
unset border; unset tics; unset grid
set lmargin 1; set rmargin 1
set key at screen 0.5,0.99 center top maxrows 2 samplen 1.5 width 2
set tmargin at screen 0.92; set bmargin at screen 0.41
set size ratio -1
set xrange [-0.2:5.2]
set yrange [-0.45:5.25]
set object 1 rectangle from -0.2,-0.45 to 5.2,-0.2 fc rgb LIGHT fs solid noborder behind
set label 1 'foundation' at 2.5,-0.33 center front
node(level, visited, large) = column('visited') == visited && (large ? column('level') >= 0 && column('level') < 4 : column('level') < 0 || column('level') >= 4)
plot data.'/fig_6_6.csv' using (node(0,1,1) ? column('x') : NaN):'y' with points ls 1 ps 0.9 title 'first cuts, visited', \
     '' using (node(0,0,1) ? column('x') : NaN):'y' with points ls 5 lc rgb BLUE ps 0.9 title 'first cuts, not visited', \
     '' using (node(0,1,0) ? column('x') : NaN):'y' with points pt 5 ps 0.35 lc rgb RED title 'the others, visited', \
     '' using (node(0,0,0) ? column('x') : NaN):'y' with points pt 4 ps 0.35 lc rgb GREY title 'the others, not visited'
unset object 1; unset label 1; unset key
set size noratio
set tmargin at screen 0.39; set bmargin at screen 0.03
set autoscale x
set yrange [7.4:-0.6]
set label 2 'eliminated last' at graph 0.02,0.93 left
set label 3 'eliminated first' at graph 0.98,0.03 right
plot data.'/fig_6_6_tree.csv' using (column('visited') == 0 ? column('place') : NaN):'level':(column('to_place')-column('place')):(column('to_level')-column('level')) with vectors nohead lc rgb GREY lw 0.8 dt 1, \
     '' using (column('visited') == 1 ? column('place') : NaN):'level':(column('to_place')-column('place')):(column('to_level')-column('level')) with vectors nohead lc rgb RED lw 2 dt 1, \
     '' using (column('visited') == 1 ? column('place') : NaN):'level' with points pt 7 ps 0.4 lc rgb RED
unset multiplot
