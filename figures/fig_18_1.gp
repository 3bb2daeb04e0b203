# Figure 18.1 - the cylinder on a plate, and what the plan says of each part.
# In: fig_18_1.csv, fig_18_1_disc.csv, fig_18_1_plate.csv   Out: fig_18_1.svg
width = 640; height = 470
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.02
set tmargin at screen 0.98
set xrange [-8:200]
set yrange [-100:62]
do for [k=0:6] { set arrow from 7*k+2,62 to 7*k+2,52 head size 3,20 filled lc rgb RED lw 1.5 dt 1 }
do for [k=0:8] { set arrow from 11*k+3,-95 to 11*k-3,-100 nohead lc rgb BLACK lw 1 dt 1 }
do for [y in '10 25 40 -20 -45 -70'] { set object circle at -3,y size 2.4 fs empty border lc rgb BLACK lw 1.2 dt 1 }
set label '{/:Italic P}/2' at 52,58 textcolor rgb RED
plot data.'/fig_18_1_plate.csv' using 'x':'y' with lines lc rgb GREY lw 0.5 dt 1, \
     data.'/fig_18_1_disc.csv' using 'x':'y' with lines lc rgb BLUE lw 0.5 dt 1, \
     data.'/fig_18_1.csv' using (column('from_x')):(column('from_y')):(102-column('from_x')):(column('y')-column('from_y')) with vectors nohead lc rgb BLACK lw 0.8 dt (4,3), \
     '' using (104):'y':'says' with labels left textcolor rgb BLACK
