# Figure 0.3 - the block before and after: held at its left side, pulled down at its right one.
# In: fig_0_3.csv, fig_0_3_before.csv   Out: fig_0_3.svg
height = 400
load 'style.gp'
unset grid
unset border
unset tics
unset key
set lmargin 1
set rmargin 1
set bmargin 0.5
set tmargin 0.5
set xrange [-6:52]
set yrange [-5:25]
set size ratio -1
set object 1 rectangle from -2,-1 to 0,21 fillstyle pattern 4 border lc rgb BLACK fillcolor rgb BLACK
do for [i=0:4] { set arrow 1+i from 41,20-5*i to 41,17-5*i size screen 0.014,20 filled lc rgb RED lw 2.2 }
set label 1 '0.5 N' at 42.5,10 left textcolor rgb RED front
set label 2 'held' at -3.2,10 center rotate by 90 textcolor rgb BLACK front
set arrow 11 from 0,23 to 40,23 heads size screen 0.012,20 lc rgb BLACK front
set label 3 '40 mm' at 20,24.3 center textcolor rgb BLACK front
plot data.'/fig_0_3_before.csv' using 'x':'y' with lines ls 8, \
     data.'/fig_0_3.csv' using 'x':'y' with lines ls 1, \
     '' using 'x':'y' with points pt 7 ps 0.6 lc rgb BLUE
