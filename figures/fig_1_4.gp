# Figure 1.4 - three carts at rest, without their stops, and with them; 3 mm of arrow for 1 N.
# In: fig_1_4.csv, fig_1_4_springs.csv   Out: fig_1_4.svg
height = 300
load 'style.gp'
unset grid
unset border
unset tics
unset key
set lmargin 1
set rmargin 1
set bmargin 0.5
set tmargin 0.5
force = 3.0  # length of an arrow [mm/N]
set xrange [-2:80]
set yrange [-0.6:2.6]
set object 1 rectangle from -1.5,-0.45 to 0,2.45 fillstyle pattern 4 border lc rgb BLACK fillcolor rgb BLACK
do for [k=0:1] { set arrow 1+k from 56-3*k,1.1-k to 56-3*k+4*force,1.1-k size screen 0.015,20 filled lc rgb BLACK lw 2 front; set label 1+k '4 N' at 56.7-3*k+4*force,1.1-k left front }
set label 4 'at rest' at 80,2.32 right
set label 5 'no stops' at 80,1.32 right
set label 6 'with stops' at 80,0.32 right
file = data.'/fig_1_4.csv'
plot data.'/fig_1_4_springs.csv' using 'x':'y' with lines ls 7 lw 1, \
     file using (0.5*(column('back')+column('front'))):'y':'back':'front':(column('y')-0.22):(column('y')+0.22) with boxxyerror fillstyle solid 1 border lc rgb BLUE fc rgb '#dcebf5' dt 1, \
     '' using (column('front') > column('stop') ? 0.5*(column('stop')+column('front')) : NaN):'y':'stop':'front':(column('y')-0.22):(column('y')+0.22) with boxxyerror fillstyle solid 1 fc rgb RED, \
     '' using 'stop':(column('y')-0.32):(0):(0.64) with vectors nohead lw 4 dt 1 lc rgb BLACK, \
     '' using (column('force') > 0 ? column('stop')+0.3+force*column('force') : NaN):(column('y')-0.1):(-force*column('force')):(0) with vectors size screen 0.015,20 filled lw 2.5 dt 1 lc rgb RED, \
     '' using (column('force') > 0 ? column('stop')+0.6 : NaN):(column('y')-0.4):(sprintf('%.1f N', column('force'))) with labels left textcolor rgb RED
