# Figure 17.1 - who solves which exhibit of the museum.
# In: fig_17_1.csv fig_17_1_rooms.csv   Out: fig_17_1.svg
width = 640; height = 960
load 'style.gp'
set lmargin at screen 0.21
set rmargin at screen 0.98
set tmargin at screen 0.76
set bmargin at screen 0.09
set border 0
unset grid
unset xtics
unset ytics
set xrange [-0.8:11.6]
stats data.'/fig_17_1.csv' using 'exhibit' nooutput
set yrange [STATS_max + 0.5:-0.5]
set key at screen 0.58, screen 0.045 center maxrows 2 samplen 1
names = "ours small\\_library lemke fischer\\_burmeister quasi\\_active\\_set\\_literal q4 node\\_to\\_segment trial\\_and\\_error penalty soft\\_springs uncoupled lenient\\_reader"
do for [k = 1:words(names)] { set label word(names, k) at first k - 1, screen 0.77 rotate by 90 left }
plot data.'/fig_17_1_rooms.csv' using (-0.7):(0.5*(column('begins') + column('ends')) - 0.5):(strcol('room')) with labels right notitle, \
     '' using (-0.8):(column('begins') - 0.5):(12.4):(0) with vectors nohead lc rgb BLACK lw 0.7 dt 1 notitle, \
     data.'/fig_17_1.csv' using (column('verdict') == 3 ? column('visitor') : NaN):'exhibit' with points pt 7 ps 0.12 lc rgb GREY title 'not for it', \
     '' using (column('verdict') == 0 ? column('visitor') : NaN):'exhibit' with points pt 7 ps 0.44 lc rgb BLUE title 'solved', \
     '' using (column('verdict') == 1 ? column('visitor') : NaN):'exhibit' with points pt 6 ps 0.44 lc rgb BLACK title 'honest', \
     '' using (column('verdict') == 2 ? column('visitor') : NaN):'exhibit' with points pt 2 ps 0.5 lw 1.8 lc rgb RED title 'wrong, caught'
