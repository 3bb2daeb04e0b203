# Figure 7.3 - the deformed plate, the pin and its pressure, both readings.   In: fig_7_3_*.csv   Out: fig_7_3.svg
width = 480; height = 680
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid
set xrange [-11:12]
set yrange [-0.8:10.8]
set xtics 5
set ytics 5
set palette maxcolors 12
set cbrange [-90:90]
set multiplot
set lmargin at screen 0.13
set rmargin at screen 0.96
set ylabel '{/:Italic y} [cm]' offset 1,0
set arrow 1 from -11,0 to 12,0 nohead back lc rgb BLACK lw 1 dt (12,3,2,3)
set colorbox horizontal user origin 0.13,0.10 size 0.83,0.025
set cblabel 'stress {/:Italic σ_{xx}} [kN/cm²]' offset 0,0.4
set cbtics 30

set title '(T) the load pulls' offset 0,-0.6
set tmargin at screen 0.95
set bmargin at screen 0.63
set object 1 circle at -0.2,0 size 4.8 arc [0:180] fc rgb LIGHT fs solid border lc rgb BLACK behind
set label 1 'pin' at 1.8,1.2 center front
set label 2 '+' at 0,6.2 center front font ',22'
set label 3 '−' at -6.3,1.4 center front font ',22' textcolor rgb 'white'
eval "plot data.'/fig_7_3_t.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1, \
     data.'/fig_7_3_t_zero.csv' using 'x':'y' with lines lc rgb 'white' lw 3 dt 1, \
     '' using 'x':'y' with lines lc rgb BLACK lw 1.5 dt 1, ".pressing(data.'/fig_7_3_t_arrows.csv', 0.035, 1)

set title '(C) the load presses'
set tmargin at screen 0.54
set bmargin at screen 0.235
set xlabel '{/:Italic x} [cm]' offset 0,0.5
unset colorbox
set object 1 circle at 0.2,0 size 4.8 arc [0:180] fc rgb LIGHT fs solid border lc rgb BLACK behind
set label 1 'pin' at -1.8,1.2 center front
set label 2 at -7,4.6
set label 3 at 6.5,1.4
eval "plot data.'/fig_7_3_c.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1, \
     data.'/fig_7_3_c_zero.csv' using 'x':'y' with lines lc rgb 'white' lw 3 dt 1, \
     '' using 'x':'y' with lines lc rgb BLACK lw 1.5 dt 1, ".pressing(data.'/fig_7_3_c_arrows.csv', 0.035, 1)
unset multiplot
