# Figure 10.2 - what the pressure of each Gauss point may be if nodes meet nodes.
# In: fig_10_2.csv, fig_10_2_three.csv   Out: fig_10_2.svg
width = 640
height = 360
load 'style.gp'
set xrange [0:1.05]
set xlabel '{/:Italic x}/{/:Italic b}'
set yrange [0:4.6]
set lmargin 8
set rmargin 2
set multiplot layout 1,2
set title '2 points an edge'
set ylabel 'pressure/{/:Italic q}_0' offset 0.5,0
plot data.'/fig_10_2.csv' using 'x':'lowest':(0):(column('highest') - column('lowest')) with vectors nohead lc rgb BLUE lw 2.5 dt 1 title 'possible', \
     sqrt(1 - x * x) with lines ls 7 title 'closed form'
set title '3 points an edge'
unset ylabel
plot data.'/fig_10_2_three.csv' using 'x':'lowest':(0):(column('highest') - column('lowest')) with vectors nohead lc rgb BLUE lw 2.5 dt 1 notitle, \
     sqrt(1 - x * x) with lines ls 7 notitle
unset multiplot
