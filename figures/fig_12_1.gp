# Figure 12.1 - right half of disc and plates: sketch and mesh.
# In: fig_12_1.csv, fig_12_1_lower.csv, fig_12_1_upper.csv   Out: fig_12_1.svg
width = 640; height = 540
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set bmargin at screen 0.02
set tmargin at screen 0.98
set xrange [-16:125]
set yrange [-112:222]
set multiplot
set lmargin at screen 0.0
set rmargin at screen 0.40
set object 1 circle at 0,50 size 50 arc [-90:90] fc rgb LIGHT fs solid noborder
set object 2 circle at 0,50 size 50 arc [-90:90] fc rgb BLACK fs empty border lc rgb BLACK lw 2 dt 1
set object 3 rectangle from 0,-95 to 95,0 fs empty border lc rgb BLACK lw 1.5 dt (6,4)
set object 4 rectangle from 0,100 to 95,195 fs empty border lc rgb BLACK lw 1.5 dt (6,4)
do for [k=0:8] { set arrow from 95./8*k,216 to 95./8*k,197 head size 4,20 filled lc rgb RED lw 1.5 dt (4,3) }
do for [k=1:12] { set arrow from 8*k,-95 to 8*k-7,-104 nohead lc rgb BLACK lw 1 dt (4,3) }
set arrow from 0,-95 to 0,195 nohead lc rgb GREY lw 1 dt (12,3,3,3)
do for [y in '-70 -35 25 50 75 130 165'] { set object circle at -4,y size 4 fs empty border lc rgb BLACK lw 1.2 dt 1 }
set arrow from 0,50 to 35.4,85.4 head size 5,20 filled lc rgb BLACK lw 1.2 dt 1
set label '{/:Italic R} = 50' at 6,42
set label '{/:Italic P}/2' at 98,208 textcolor rgb RED
set label '95' at 40,-84
set label '95' at 72,-47
set label '95' at 72,147
plot NaN notitle
unset object; unset arrow; unset label
set lmargin at screen 0.36
set rmargin at screen 0.72
set xrange [-3:125]
plot for [part in '_lower _upper'] data.'/fig_12_1'.part.'.csv' using 'x':'y' with lines lc rgb BLACK lw 0.3 dt 1, \
     data.'/fig_12_1.csv' using 'x':'y' with lines lc rgb BLUE lw 0.3 dt 1
set lmargin at screen 0.69
set rmargin at screen 0.99
set bmargin at screen 0.2
set tmargin at screen 0.8
set xrange [0:3]
set yrange [-2.2:3]
set label 'contact' at 1.5,3.3 center
plot data.'/fig_12_1_lower.csv' using 'x':'y' with lines lc rgb BLACK lw 0.6 dt 1, \
     data.'/fig_12_1.csv' using 'x':'y' with lines lc rgb BLUE lw 0.6 dt 1
unset multiplot
