# Figure 11.9 - errors of five elements against the size of their cells.   In: fig_11_9.csv   Out: fig_11_9.svg
width = 900; height = 520
load 'style.gp'
set multiplot
set logscale xy
set grid xtics ytics mytics back ls 101, ls 102
set mytics 10
set xrange [3.4:40]
set xtics (4,8,16,32)
set format y '%g'
set tmargin at screen 0.80; set bmargin at screen 0.19
set label 9 'edges on the half-width' at screen 0.53,0.025 center
names = 'q4 q4_incompatible t3 q8 t6'
style(k) = k + 1
guide(x, at, value, p) = value*(at/x)**p
unset key
do for [k=0:4] { set label 20+k word(names,k+1) noenhanced at screen word('0.07 0.19 0.50 0.66 0.82',k+1),0.95 left point lt style(k) offset 1.2,0 }
set title 'displacements [%]'
set lmargin at screen 0.09; set rmargin at screen 0.35
set yrange [0.04:40]
set label 1 'slope 1' at 12,11 left textcolor rgb GREY
set label 2 'slope 3/2' at 3.9,0.12 left textcolor rgb GREY
plot for [k=0:4] data.'/fig_11_9.csv' every :::k::k using 'edges':'energy' with linespoints ls style(k) notitle, \
     guide(x,8,14,1) with lines ls 8 notitle, guide(x,8,0.3,1.5) with lines ls 8 notitle
unset label 2; unset label 9; do for [k=20:24] { unset label k }
set title 'pressure [%]'
set lmargin at screen 0.42; set rmargin at screen 0.66
set yrange [0.3:12]
set label 1 'slope 1' at 11,5.2 left textcolor rgb GREY
plot for [k=0:4] data.'/fig_11_9.csv' every :::k::k using 'edges':'pressure' with linespoints ls style(k) notitle, \
     guide(x,8,5.5,1) with lines ls 8 notitle
set title 'half-width [%]'
set lmargin at screen 0.75; set rmargin at screen 0.99
set yrange [0.004:8]
set label 1 'slope 2' at 12,1.3 left textcolor rgb GREY
plot for [k=0:4] data.'/fig_11_9.csv' every :::k::k using 'edges':'half_width' with linespoints ls style(k) notitle, \
     guide(x,8,2.2,2) with lines ls 8 notitle
unset multiplot
