# Figure 21.2 - the separators of the cantilever as a tree, and the path of the row of one contact.
# In: fig_21_2.csv   Out: fig_21_2.svg
width = 760; height = 400
load 'style.gp'
set xrange [-1:51]
set yrange [7.1:-0.6]
set xlabel 'place along the beam [cm]'
set ylabel 'depth in the tree'
set border 1
set ytics scale 0 0,1,6
set grid noxtics noytics
set key outside top center horizontal
file = data.'/fig_21_2.csv'
do for [w=1:8] { set style arrow w nohead lc rgb SKY lw 1.1*w dt 1 }
plot for [w=1:8] file using (ceil(column('rows')/10.0) == w ? column('x') : NaN):'depth':(column('above_x')-column('x')):(column('above_depth')-column('depth')) with vectors as w title (w == 3 ? 'the thicker, the more rows pass' : ''), \
     '' using (column('one') > 0 ? column('x') : NaN):'depth':(column('above_x')-column('x')):(column('above_depth')-column('depth')) with vectors nohead lc rgb RED lw 2.5 dt (6,3) title 'the row of one contact', \
     '' using 'x':'depth':(0.25+0.09*sqrt(column('own'))) with points pt 7 ps variable lc rgb BLUE title 'separator'
