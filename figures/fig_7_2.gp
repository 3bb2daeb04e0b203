# Figure 7.2 - the deformed plate and the pin, both readings.   In: fig_7_2_t.csv, fig_7_2_c.csv   Out: fig_7_2.svg
width = 760; height = 300
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [cm]'
set xrange [-11:12]
set yrange [-0.5:11.5]
set xtics 5
set ytics 5
set palette maxcolors 12
set cbrange [-90:90]
set multiplot
set lmargin at screen 0.10
set rmargin at screen 0.465
set title '(T) the load pulls'
set ylabel '{/:Italic y} [cm]'
unset colorbox
set object 1 circle at -0.2,0 size 4.8 arc [0:180] fc rgb LIGHT fs solid border lc rgb BLACK behind
plot data.'/fig_7_2_t.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1
set lmargin at screen 0.51
set rmargin at screen 0.875
set title '(C) the load presses'
unset ylabel
set format y ''
set colorbox user origin 0.885,0.25 size 0.02,0.5
set cblabel 'σ_{xx} [kN/cm²]' offset 0.5,0
set cbtics 30
set object 1 circle at 0.2,0 size 4.8 arc [0:180] fc rgb LIGHT fs solid border lc rgb BLACK behind
plot data.'/fig_7_2_c.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1
unset multiplot
