# Figure 10.3 - pressures of 2, 3 and 4 Gauss points an edge below the disc.
# In: fig_10_3.csv, fig_10_3_three.csv, fig_10_3_four.csv, fig_10_3_nodal.csv   Out: fig_10_3.svg
width = 640
height = 360
load 'style.gp'
set xrange [0:1.15]
set xlabel '{/:Italic x}/{/:Italic b}'
set yrange [0:5.8]
set xtics 0, 0.5
set lmargin 5.5
set key samplen 1 noopaque at graph 1.1, 0.98
set rmargin 1
set multiplot layout 1,3
array file[3] = ['fig_10_3', 'fig_10_3_three', 'fig_10_3_four']
array name[3] = ['2 points an edge', '3 points an edge', '4 points an edge']
set ylabel 'pressure/{/:Italic q}_0' offset 1,0
do for [k = 1:3] {
  set title name[k]
  if (k == 2) { unset ylabel }
  plot data.'/'.file[k].'.csv' using 'x':'p' with impulses lc rgb RED lw 1.2 notitle, \
       data.'/'.file[k].'.csv' using 'x':'p' with points ls 2 title (k == 1 ? 'Gauss points' : ''), \
       sqrt(1 - x * x) with lines ls 7 title (k == 1 ? 'closed form' : ''), \
       data.'/fig_10_3_nodal.csv' using 'x':'p' with points ls 1 pt 6 ps 0.9 title (k == 1 ? 'nodes' : '')
}
unset multiplot
