# Figure 21.1 - the order of elimination, and what the rows of A meet.   In: fig_21_1.csv, fig_21_1_tree.csv   Out: fig_21_1.svg
width = 480; height = 640
load 'style.gp'
set multiplot
unset border; unset tics; unset grid
set lmargin 1; set rmargin 1
set key at screen 0.5,0.99 center top maxrows 3 samplen 1 width -2
set tmargin at screen 0.895; set bmargin at screen 0.40
set size ratio -1
set xrange [-0.2:5.2]
set yrange [-0.45:5.25]
set object 1 rectangle from -0.2,-0.45 to 5.2,-0.2 fc rgb LIGHT fs solid noborder behind
set label 1 'foundation' at 2.5,-0.33 center front
# Symbols of the generations 0 to 3, filled and hollow; -1 stands for all that follow.
filled = '5 7 9 13'; hollow = '4 6 8 12'
colours = sprintf('%s %s %s %s', BLACK, BLUE, GREEN, PURPLE)
names = "'first cut' second third fourth"
is(generation, visited) = column('visited') == visited && (generation < 0 ? column('level') < 0 || column('level') > 3 : column('level') == generation)
plot for [g=0:3] data.'/fig_21_1.csv' using (is(g,1) ? column('x') : NaN):'y' with points pt int(word(filled,g+1)) ps 0.9 lc rgb word(colours,g+1) title word(names,g+1), \
     for [g=0:3] '' using (is(g,0) ? column('x') : NaN):'y' with points pt int(word(hollow,g+1)) ps 0.9 lc rgb word(colours,g+1) notitle, \
     '' using (is(-1,1) ? column('x') : NaN):'y' with points pt 7 ps 0.4 lc rgb RED title 'later, visited', \
     '' using (is(-1,0) ? column('x') : NaN):'y' with points pt 6 ps 0.4 lc rgb GREY title 'later, not visited'
unset object 1; unset label 1; unset key
set size noratio
set tmargin at screen 0.39; set bmargin at screen 0.03
set autoscale x
set yrange [7.4:-0.6]
set label 2 'eliminated last' at graph 0.02,0.93 left
set label 3 'eliminated first' at graph 0.98,0.03 right
way(visited) = column('visited') == visited ? column('place') : NaN
plot data.'/fig_21_1_tree.csv' using (way(0)):'level':(column('to_place')-column('place')):(column('to_level')-column('level')) with vectors nohead lc rgb GREY lw 0.8 dt 1, \
     '' using (way(1)):'level':(column('to_place')-column('place')):(column('to_level')-column('level')) with vectors nohead lc rgb RED lw 2 dt 1, \
     for [g=0:3] '' using (is(g,1) ? column('place') : NaN):'level' with points pt int(word(filled,g+1)) ps 1 lc rgb word(colours,g+1), \
     for [g=0:3] '' using (is(g,0) ? column('place') : NaN):'level' with points pt int(word(hollow,g+1)) ps 1 lc rgb word(colours,g+1), \
     '' using (is(-1,1) ? column('place') : NaN):'level' with points pt 7 ps 0.4 lc rgb RED
unset multiplot
