# Figure 16.3 - what four programs need for Hertz's contact on the same four meshes, and how well they meet the closed form.
# In: fig_16_3.csv   Out: fig_16_3.svg
width = 640; height = 430
load 'style.gp'
set logscale xy
set yrange [0.0007:1]
set format y '%g'
set format x '%g'
set grid xtics ytics
set bmargin at screen 0.36
set tmargin at screen 0.96
set lmargin at screen 0.16
set rmargin at screen 0.55
set key at screen 0.05,0.02 left bottom maxrows 2 width -6 samplen 2
set multiplot
set xlabel 'processor time [s]'
set ylabel 'larger error of {/:Italic q}_0, {/:Italic b} [%]' offset 1.6,0
set xrange [0.01:200]
set label 1 '1399' at 0.02,0.12 left textcolor rgb BLACK
set label 2 '84 426 nodes' at 1.5,0.0015 right textcolor rgb BLACK
plot data.'/fig_16_3.csv' using 'signorini_seconds':'signorini_error' with linespoints ls 1 title 'this library', \
     '' using 'getfem_seconds':'getfem_error' with linespoints ls 2 title 'GetFEM', \
     '' using 'ccx_surface_seconds':'ccx_surface_error' with linespoints ls 3 title 'CalculiX, surfaces', \
     '' using 'ccx_node_seconds':'ccx_node_error' with linespoints ls 4 title 'CalculiX, nodes'
unset label
set xlabel 'largest memory [MB]'
unset ylabel
set format y ''
set lmargin at screen 0.58
set rmargin at screen 0.97
set xrange [5:5000]
plot data.'/fig_16_3.csv' using 'signorini_MB':'signorini_error' with linespoints ls 1 notitle, \
     '' using 'getfem_MB':'getfem_error' with linespoints ls 2 notitle, \
     '' using 'ccx_surface_MB':'ccx_surface_error' with linespoints ls 3 notitle, \
     '' using 'ccx_node_MB':'ccx_node_error' with linespoints ls 4 notitle
unset multiplot
